// Highest less lowest height around each cell.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

/// Over a square of 2 radius + 1 cells a side, cut at the edge. Metres. REQUIRES: radius >= 0. Parallel; linear
/// whatever the radius (van Herk 1992, Gil and Werman 1993).
ScalarField local_relief(const HeightField& terrain, int radius, const RunContext& run);

}  // namespace seamount::hydrology
