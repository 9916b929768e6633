// Cells of half the size that keep the means of the large ones: the mean of each 2 x 2 is the cell that they come from.
//
// Along rows and then columns, each cell is split by the parabola that has its mean and passes at its two borders
// through what a quadratic spline of the cell means has there (the derivative of the cubic spline through their running
// sum, cut off four cells away): once differentiable but for that cut, exact for planes, sharper than an interpolation
// of the same cells because it knows them to be means.
#pragma once

#include <cstdint>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// A grid with `margin` more cells on all sides, in which it goes on by point reflection about its border cells: a
/// slope goes on as a slope. Only cells of the frame are meant; its place is not kept.
Grid<float> with_reflected_margin(const Grid<float>& grid, int margin, const RunContext& run);

/// The frame with cells of half the size.
GridFrame halved_frame(GridFrame frame);

/// Cells that are the same as all of their neighbours, such as those of flat water: 1, others 0. Parallel.
Grid<uint8_t> level_cells(const Grid<float>& grid, const RunContext& run);

/// `fine` += the cells of half the size. Those of a cell that is `level` (null: none is) are as high as it all over,
/// and their neighbours begin there. Means are kept to float rounding. REQUIRES: fine has halved_frame's size, level
/// the grid's. Parallel; about 5 ns and 2 bytes of memory per fine cell.
void add_halved_cells(const Grid<float>& grid, const Grid<uint8_t>* level, Grid<float>& fine, const RunContext& run);

/// Means of 2 x 2 cells. REQUIRES: both sides are even.
Grid<float> means_of_four(const Grid<float>& fine, const RunContext& run);

}  // namespace seamount::geom
