// Fans: what rivers have just laid down spreads to the sides.
//
// Water takes one way per step (drainage.h), while a real river that drops its load wanders over all of its plain in
// the years of a step. So the load of a step does not stay a dam of one cell's width: as far as it stands over the
// ground beside it, it runs off to the slope of a fan.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/ops/erosion/layers.h"

namespace seamount::erosion {

/// Spreads `fresh`, the uppermost metres of the sediment (used up on the way), over some cells around. `share` and
/// `next` are room to work in. Parallel, about 60 ns per cell.
void spread_deposits(Layers& ground, ScalarField& fresh, const Maps& site, ScalarField& share, ScalarField& next,
                     const RunContext& run);

}  // namespace seamount::erosion
