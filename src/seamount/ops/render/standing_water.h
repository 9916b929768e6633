// What pictures show below and above the sea's level against the rule that water is up to there: dry ground that lies
// lower, and lakes that stand higher.
#pragma once

#include <cstdint>
#include <optional>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::render {

/// 1 on ground below sea level that is no sea (geom/water/inland.h) and on what surrounds it, 0 elsewhere; an empty
/// grid where there is none. Linear.
Mask dry_below_sea(const HeightField& terrain, const std::optional<double>& min_sea_m2, const RunContext& run);

/// Depth of lakes in metres, and on the ground around them how far it is above their surface, as less than 0 (at least
/// -kShoreLimit_m, which is the value far from any lake): the shore is where it is 0, also after resampling. An empty
/// grid without lakes. `lake`: metres of water over the terrain, 0 or NaN where there is none. Throws
/// IncompatibleInputs for a lake of another size. Linear.
ScalarField depth_around_lakes(const HeightField& terrain, const ScalarField* lake, const RunContext& run);
inline constexpr float kShoreLimit_m = 5.0F;

/// Raises ground to the surface of its lakes.
void raise_to_lakes(HeightField& ground, const ScalarField& depth);

}  // namespace seamount::render
