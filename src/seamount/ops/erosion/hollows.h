// What does not drain at the end of a run: lakes, which are declared, and shallow hollows, which are filled.
#pragma once

#include "seamount/ops/erosion/drainage.h"
#include "seamount/ops/erosion/layers.h"

namespace seamount::erosion {

/// Hollows on land that are shallower than this, or than this share of a cell, are filled with sediment.
constexpr double kHollow_m = 1.0, kHollowShare = 0.05;

/// `lake` becomes the depth of standing water of what stays. With `fill`, shallow hollows outside of masks trap
/// sediment that would have left the map: ledger.exported goes down by as much, and their floor rises by a rounding
/// step towards where water comes from, so that they drain. `level` is spent.
void settle_hollows(Layers& ground, const Maps& site, const Drainage& drainage, float sea_m, bool fill,
                    ScalarField& lake, ScalarField& level, Ledger& ledger);

}  // namespace seamount::erosion
