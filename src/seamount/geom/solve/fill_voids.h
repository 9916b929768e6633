// Heights for cells of which nothing is known.
#pragma once

#include <cstdint>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Gives cells that are NaN the membrane through the rims of their holes (Laplace's equation; no flux through the
/// grid's edge); all others keep their values. Returns how many there were. Throws IncompatibleInputs for a grid of
/// which nothing is known. Linear: hole by hole, or in one solution of the whole grid where that is less; about 0.1 us
/// per cell of a window, parallel, and eight more grids of a window's size.
int64_t fill_voids(Grid<float>& grid, const RunContext& run);

// The same piece by piece, for grids of which only windows are in memory. A window has the cells around what is filled,
// one more on each side where the grid goes on, and may have other holes, which stay.

/// Fills the hole that a cell of a window is in: the first of its cells, row by row, by its number in the window. The
/// same values as of fill_voids(), where that does not fill all as one. REQUIRES: the cell is NaN, and the hole has a
/// rim. Linear; cost and memory as above.
void fill_hole(Grid<float>& window, int64_t first, const RunContext& run);

/// Cells of the window of a hole that many cells wide and high: one more on each side.
int64_t hole_window(int64_t columns, int64_t rows);

/// Whether fill_voids() solves all holes of a grid of so many cells as one, by the cells that their windows have
/// together.
bool filled_as_one(int64_t windows, int64_t grid_cells);

}  // namespace seamount::geom
