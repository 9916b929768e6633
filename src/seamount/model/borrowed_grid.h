// Grids over cells that stand in somebody else's memory, such as an array of NumPy.
#pragma once

#include <memory>

#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"

namespace seamount {

/// A grid whose cells are those at `cells`, frame.cells() of them, row by row from the north: nothing is copied and
/// nothing written to them. `owner` is kept until the grid is gone; whoever changes the cells meanwhile changes the
/// grid. Copies of the grid are grids like any other. Throws std::bad_alloc.
std::shared_ptr<const Grid<float>> borrow_cells(GridFrame frame, const float* cells, std::shared_ptr<const void> owner);
/// REQUIRES: every cell is a Region.
std::shared_ptr<const LabelMap> borrow_cells(GridFrame frame, const Region* cells, std::shared_ptr<const void> owner);

}  // namespace seamount
