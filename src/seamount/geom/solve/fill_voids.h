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

}  // namespace seamount::geom
