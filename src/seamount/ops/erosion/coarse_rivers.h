// Rivers of a coarse terrain as smooth courses on finer cells: through each coarse cell a curve from where water enters
// it to where it leaves, falling all the way. Fine cells drawn from coarse heights alone would dam them wherever they
// run across the corner of two cells.
#pragma once

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::erosion {

struct RiverCourses {
  double least_flow = 0.0;  ///< discharge in m3 per year of the smallest river, > 0
  double side_slope = 1.0;  ///< rise over run of the ground beside a river, at most
  double bend = 0.25;       ///< of a coarse cell: how far courses leave its middle at most, [0, 0.4]
  float sea_m = 0.0F;
};

/// What rivers ask of the ground around them.
struct RiverGround {
  ScalarField highest;  ///< how high it may be: the rivers' height in their beds, rising beside them for the width of a
                        ///< coarse cell; infinity elsewhere
  ScalarField distance;  ///< to the nearest bed in metres; at most the width of a coarse cell
};

/// Beds are at least as wide as a fine cell's diagonal. A cell hangs on the coarse cells up
/// to five away from it: only those are read.
RiverGround river_ground(const GridFrame& fine, const HeightField& worn, const ScalarField& flow,
                         const RiverCourses& courses, Seed seed, const RunContext& run);

}  // namespace seamount::erosion
