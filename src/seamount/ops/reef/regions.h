// Connected regions of a mask.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/model/grid.h"

namespace seamount::reef {

/// A region of cells that share sides.
struct RegionOfMask {
  std::vector<int64_t> cells;  ///< row * width + column
  bool at_edge = false;        ///< touches the edge of the grid
};

/// Regions of mask != 0, in the order of their first cells. Linear; 8 bytes a cell.
std::vector<RegionOfMask> regions_of(const Grid<uint8_t>& mask);

/// Clears regions smaller than least_m2 that do not touch the edge of the grid.
void drop_small(Grid<uint8_t>& mask, double least_m2);

}  // namespace seamount::reef
