// Basins of a raster and the passes between them: what filling depressions, routing through them, and the prominence of
// summits are made of.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/geom/water/flow.h"

namespace seamount::geom {

/// The basin of all cells that drain off the map or into the sea; those of pits follow in scan order.
inline constexpr int32_t kOutside = 0;

struct Basins {
  Grid<int32_t> of;           ///< basin of each cell
  std::vector<int32_t> pits;  ///< cell of each basin's pit; -1 for the outside
  int32_t count() const { return static_cast<int32_t>(pits.size()); }
};

/// The lowest place where two basins meet.
struct Pass {
  float height;  ///< of the higher of the two cells
  int32_t a, b;  ///< basins, a < b
  int32_t cell;  ///< one of the two cells; the other is its neighbour to the east, south-west, south or south-east
};

/// Parallel, linear.
Basins find_basins(const FlowDirections& directions, const RunContext& run);

/// The passes between neighbouring basins from low to high; a pair may appear more than once. Parallel but for sorting;
/// linear in the cells, n log n in the cells where basins meet.
std::vector<Pass> find_passes(const HeightField& terrain, const Basins& basins, const RunContext& run);

}  // namespace seamount::geom
