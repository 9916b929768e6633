// Strokes as cells and as lines that agree: one cell wide, without circles.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/ops/sketch/ground.h"
#include "seamount/ops/sketch/strokes.h"

namespace seamount::sketch {

struct Inked {
  Mask cells;                   ///< 1 or 0
  std::vector<Polyline> lines;  ///< through the cells' middles but for 0.4 cells, downstream, joined at their ends
};

/// Strokes on the ground's land. Where they enclose less than a square of side close_m they become one; of what still
/// makes a circle the shortest part is left out. With `outlets` (rivers) pieces that come neither to the edge, nor to
/// the sea, nor to one of the `ends` are left out; so are pieces shorter than least_m, which coasts cut off. Linear;
/// 9 bytes per cell.
Inked ink(const Strokes& strokes, const Ground& ground, bool outlets, const std::vector<Vec2>& ends, double close_m,
          double least_m, const RunContext& run);

}  // namespace seamount::sketch
