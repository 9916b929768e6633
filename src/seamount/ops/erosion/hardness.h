// How hard the bedrock of a run is, from place to place.
#pragma once

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::erosion {

/// Rock at the white end of a picture of hardness, in times what `erodibility` says; black is 1.
inline constexpr float kHardestOfPicture = 10.0F;
/// The softest rock that a map may ask for: a tenth as hard as `erodibility` says.
inline constexpr float kSoftest = 0.1F;

/// Takes a given map as factors on hardness. One that reaches from 0 to at most 1 is a mask or picture, whose 0 would
/// be rock without any hardness: it becomes 1 at 0, kHardestOfPicture at 1, geometric between. Of any other map, what
/// is below kSoftest becomes that. Both are said. An empty map stays empty. Linear.
void settle_hardness(ScalarField& hardness, const RunContext& run);

/// Bedrock is nowhere the same: makes a hardness of 1 on average (empty), or the given one, vary by up to
/// (1 + v) / (1 - v) times. Parallel.
void vary_hardness(ScalarField& hardness, const GridFrame& frame, double variation, Seed seed, const RunContext& run);

}  // namespace seamount::erosion
