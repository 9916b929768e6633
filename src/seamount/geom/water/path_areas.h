// What drains through a cell over short ways: a share of the drained area that hangs on a neighbourhood alone, so that
// it is the same in a window of a raster as in the whole.
#pragma once

#include <cstdint>

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"

namespace seamount::geom {

/// Cells whose water passes through each cell after fewer than 2^doublings steps, itself included: flow_accumulation()
/// cut off there. A cell hangs on cells so many steps away. By doubling of ways: each pass adds what comes over ways
/// twice as long. REQUIRES: doublings in [0, 20]. Parallel; doublings passes, 16 bytes per cell.
Grid<uint32_t> path_areas(const FlowDirections& directions, int doublings, const RunContext& run);

}  // namespace seamount::geom
