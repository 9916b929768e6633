// The ground that a sketch is made of: a terrain and what of it is land, seen without its detail.
#pragma once

#include <optional>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::sketch {

struct Ground {
  HeightField heights;  ///< hollows below sea level lie just above it, unknown cells below all (geom/water/inland.h)
  Mask land;            ///< 1 or 0, which it is in unknown cells; empty: all of it is land
  float sea_m;          ///< geom::kNoSea where all is land; of unknown cells where there is no sea

  bool is_land(size_t cell) const { return land.empty() || land.data()[cell] != 0.0F; }
  /// Of all cells, [0, 1].
  double land_share() const;
};

/// What lies above sea level, or everything that is known. A terrain of which less than a hundredth is sea may have one
/// that is none by its heights, since radar sees water as some metres of noise: ground within 5 m of sea level that is
/// level (within 2 m over a 128th of the terrain's longer side all around, blurred by 0.7 of that), covers at least
/// `min_sea_m2` (a hundredth of the terrain if absent) and touches the edge is taken for it. Says so, and where there
/// is no land. Linear; 12 bytes per cell.
Ground find_ground(const HeightField& terrain, bool sea, const std::optional<double>& min_sea_m2,
                   const RunContext& run);

/// Land blurred with land alone (a Gaussian of deviation blur_m, divided by the same blur of the land), on cells of
/// `frame`, which are land where half of them is; the sea is level. Parallel; 12 bytes per cell.
HeightField blurred_land(const Ground& ground, double blur_m, const GridFrame& frame, const RunContext& run);

}  // namespace seamount::sketch
