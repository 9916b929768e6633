// Passes of reef.grow: no lagoon is cut off from the sea.
//
// A lagoon fills and empties with every tide, and where its water leaves no coral closes the reef: 1 pass in 16 km of
// barrier, 0.1 to 1 km wide, to 65 m deep, deeper and wider for larger lagoons. They lie where the reef is thin and in
// the lee, and over drowned valleys, where the ground is lowest.
#pragma once

#include <optional>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/reef/surface_params.h"

namespace seamount::reef {

/// Depth to which passes are sought: water that is shallower is closed at low tide.
inline constexpr float kPassable_m = 4.0F;

/// Metres of water in passes, 0 outside and soft between, on the frame of all inputs: `ground` before and `reef` after
/// growth in metres, exposure as of shape.h. Each piece of water deeper than kPassable_m and of at least
/// passes.least_km2 that reefs cut off from the frame's edge gets one for each passes.spacing_m of its shore, at least
/// one; wide enough for cells of `cell_m`. What the ground itself encloses stays closed. Unknown ground (NaN) is open.
/// Empty where nothing is cut off. About 100 ns a node where something is, else 20.
ScalarField find_passes(const HeightField& ground, const HeightField& reef, const ScalarField& exposure,
                        const PassParams& passes, double cell_m, const RunContext& run);

}  // namespace seamount::reef
