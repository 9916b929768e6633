// Where the rivers of an island meet the sea.
#pragma once

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::island {

struct RiverMouth {
  Vec2 place;
  double catchment_m2 = 0;
};

/// Mouths of all rivers with a catchment of at least a hundredth of the land above `sea_level_m`, the largest first, on
/// a lattice of at most 256 cells a side. A few ms.
std::vector<RiverMouth> river_mouths(const HeightField& terrain, float sea_level_m, const RunContext& run);

}  // namespace seamount::island
