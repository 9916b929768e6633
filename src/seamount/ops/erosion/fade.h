// What a mask does to a run: the share of its change that is kept.
//
// Rates that a mask slows do not fade: over a hundred thousand years a tenth of the rain cuts nearly as deep as all of
// it, and the ground falls off a cliff where the mask ends. So erosion acts fully wherever the mask is above 0, ground
// where it is 0 holds still, and in the end each cell keeps the mask's share of what has happened to it. Where a hard
// edge leaves no room for that, the change fades in over as many metres as its depth asks for.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/ops/erosion/layers.h"

namespace seamount::erosion {

/// The steepest slope that fading may add to the ground's own: a share of the mean slope of what erosion made.
double slope_of_fade(const HeightField& after);

/// 1 where a mask is above 0; an absent mask stays absent.
Mask opened(const Mask& mask);

/// The mask, lowered until the share grows by no more than slope_of_fade() / A per metre, A being the greatest change
/// around, so that share times change is nowhere steeper than that for the mask's sake. Never above the mask; the mask
/// itself where it is that soft. Linear, one thread.
Mask faded(const Mask& mask, const HeightField& before, const HeightField& after, const RunContext& run);

/// Takes back what a share does not keep: surface and layers become before + share * (after - before). The ledger's
/// volumes shrink with the change, and its exported is what the kept ground lost. REQUIRES: the same frames.
void keep_share(const Mask& share, const Layers& before, Layers& after, Ledger& ledger, const RunContext& run);

}  // namespace seamount::erosion
