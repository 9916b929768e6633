// Sliding to the angle of repose, one round for one layer.
//
// Talus after Musgrave, Kolb and Mace 1989: where a layer is steeper than its angle towards a neighbour, part of the
// excess goes to all such neighbours, in proportion to it.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/ops/erosion/ground.h"

namespace seamount::erosion {

enum class Layer { sediment, rock, bedrock };

/// Moves what is too steep by one cell: sediment and rock stay what they are, bedrock becomes rock. speed in (0, 1]:
/// share of what would level the excess. `share` and `next` are room to work in; `next` is swapped with the surface.
/// Parallel and vectorised, about 4 ns per cell.
void slide(Ground& ground, const Site& site, Layer layer, double angle_deg, double speed, ScalarField& share,
           ScalarField& next, const RunContext& run);

}  // namespace seamount::erosion
