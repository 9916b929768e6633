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

}  // namespace seamount::geom
