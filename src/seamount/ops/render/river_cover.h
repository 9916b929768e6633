// Rivers as the share of each cell that they cover, so that those narrower than a cell are seen as a tint.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"

namespace seamount::render {

/// A line is as wide as its width_m says, else 3 m times 1.7 for each order (or value) above the first. What lies
/// outside is cut. Throws IncompatibleInputs for lines of another coordinate system. Linear in the cells that they
/// touch.
ScalarField river_cover(const Drawing& rivers, const GridFrame& frame, const RunContext& run);

}  // namespace seamount::render
