// Sliding to the angle of repose, one round for one layer.
//
// Talus after Musgrave, Kolb and Mace 1989: where a layer is steeper than its angle towards a neighbour, part of the
// excess goes to all such neighbours, in proportion to it.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/ops/erosion/layers.h"

namespace seamount::erosion {

/// What slides: the loose layer itself, or the bedrock below it, which becomes part of the layer.
enum class Sliding { layer, bedrock_below };

/// Moves what is too steep by one cell: the surface, and the layer with it. speed in (0, 1]: share of what would level
/// the excess. `share` and `next` are room to work in; `next` is swapped with the surface. Parallel and vectorised,
/// about 4 ns per cell.
void slide(HeightField& surface, ScalarField& layer, Sliding what, const Maps& site, double angle_deg, double speed,
           ScalarField& share, ScalarField& next, const RunContext& run);

}  // namespace seamount::erosion
