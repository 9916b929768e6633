// One evaluation of a network over a map.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/learned/layers.h"
#include "seamount/ops/learned/planes.h"

namespace seamount::learned {

/// Network::evaluate() for inputs that agree. `tile`: rows of the map whose levels up to stride 4 are in memory at
/// once, a multiple of the architecture's stride; 0: chosen by size.
ScalarField evaluate(const Layers& layers, const Planes& planes, const GridFrame& frame, const RunContext& run,
                     int tile);

}  // namespace seamount::learned
