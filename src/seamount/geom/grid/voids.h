// Cells of which nothing is known: NaN in grids of heights and other numbers.
#pragma once

#include <cstdint>
#include <span>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Whether any value is NaN. Vectorised: a look before loops that would look at each.
bool any_void(std::span<const float> values);

/// How many cells are NaN. Parallel, linear: a read of the grid.
int64_t count_voids(const Grid<float>& grid, const RunContext& run);

/// Bilinear over the cells that are known, at fractional (column, row); NaN where they are less than half of the weight
/// and more than half a cell beyond the outer centres.
float sample_known(const Grid<float>& grid, double column, double row);

}  // namespace seamount::geom
