// Ridges as the rivers of the inverted terrain (P1 sec. 5.1): the terrain turned upside down.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Height of what no way leads over.
inline constexpr float kFlowWall = 1e9F;

/// -terrain where it lies above the sea, kFlowWall elsewhere and on a frame of one more cell all around, so that water
/// never leaves: cell (x, y) of the terrain is (x + 1, y + 1) of the result. There summits are pits, and filling them
/// would drown the ridges; route_through_pits() with kFlowWall leads from summit to higher summit instead. Parallel.
HeightField invert_with_walls(const HeightField& terrain, float sea_level_m, const RunContext& run);

}  // namespace seamount::geom
