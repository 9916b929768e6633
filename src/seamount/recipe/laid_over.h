// A raster that lies nowhere, such as a painted mask, laid over the frame of what it goes with.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::recipe {

/// `picture` stretched over all of `frame`: linear between the middles of its pixels, averaged over cells where those
/// are larger. What is the same everywhere stays exactly so; never outside of the picture's own range. Unknown pixels
/// (NaN) do not count; NaN where none does. Parallel.
ScalarField laid_over(const ScalarField& picture, const GridFrame& frame, const RunContext& run);

}  // namespace seamount::recipe
