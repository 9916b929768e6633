// A frame for shapes that come without one.
#pragma once

#include <vector>

#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// `wanted` where all places lie in it (or stick out by a tenth of its size), else one of as many cells along its
/// longer side that holds them. REQUIRES: finite places, at least one; wanted has cells. Linear.
GridFrame frame_around(const std::vector<Vec2>& places, const GridFrame& wanted);

}  // namespace seamount::geom
