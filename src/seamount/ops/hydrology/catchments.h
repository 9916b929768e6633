// Catchments as areas.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

/// The catchments of at least min_area_m2, from the largest on: areas named "catchment 1", ... with area_m2 and the
/// place of their mouth, mouth_x and mouth_y. `basins` numbers them by size from 1 on, and `cells`, what drains through
/// a cell, is greatest at the mouth. Linear in the cells and in the windows of the catchments.
Drawing trace_catchments(const ScalarField& basins, const Grid<uint32_t>& cells, double min_area_m2,
                         const RunContext& run);

}  // namespace seamount::hydrology
