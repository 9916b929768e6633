// What comes to rest in standing water does not lie where a single way of the water left it.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/geom/water/incise.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Spreads what incise() laid down in each lake over its floor, as a share of the water's depth, so that a lake silts
/// up evenly and full to its brim; and what reached the sea over the sea floor around, `reach_m` wide (a Gaussian's
/// deviation), up to `fill` of the depth. What finds no room is lost. Lakes: `terrain` below `filled` and above the sea
/// (kNoSea for none). Volumes of lakes stay, to rounding. Linear; one thread but for the sea; 20 ns a cell, and 40 more
/// where there is sea.
struct Settling {
  float sea_level_m = kNoSea;
  double reach_m = 2000;  ///< > 0, at most a quarter of the map counts
  float fill = 0.95F;     ///< [0, 1]
};
void settle(const HeightField& terrain, const HeightField& filled, const Settling& settling, Incised& made,
            const RunContext& run);

}  // namespace seamount::geom
