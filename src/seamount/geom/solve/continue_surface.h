// A known part of a surface goes on beyond its rim with the slope that it has there, so that no crease shows where
// ground that was made begins.
//
// Two steps. Where what was made leaves the rim with another slope than the known part arrives with, it is tilted:
//
//   z(x) += S(x) L (1 - exp(-d(x) / L)) (1 - smoothstep(d(x) / far)),  d the distance from the known part in cells,
//
// with S the difference of the slopes across the rim, spread (geom/grid/pyramid_fill.h), so that ground beside a slope
// is lowered, not dammed, and keeps its own detail. Then the cells next to the rim become the mean of what the planes
// that touch the surface at rim cells p say, Shepard's method with planes instead of values (Renka 1988), faded over
// `near` cells:
//
//   T(x) = sum w_p (k_p + g_p . (x - p)) / sum w_p,  w_p = |x - p|^-4,  g_p the slope of k at p,
//   z(x) += (1 - smoothstep(d(x) / (near + 1))) (T(x) - z(x)).
//
// A plane goes on as that plane.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

struct Continuation {
  int near = 8;       ///< cells
  float far = 32.0F;  ///< cells
  float bend = 7.0F;  ///< L, cells
};

/// Known cells (not NaN) replace those of `made`, which should meet them, and cells up to `far` cells from them change.
/// REQUIRES: grids of one size, near >= 1, far and bend > 0. Parallel; the same bytes on any number of threads; linear
/// in the cells, and about 5 us for each beside a rim; 40 bytes per cell.
void continue_surface(const HeightField& known, const Continuation& options, HeightField& made, const RunContext& run);

}  // namespace seamount::geom
