// Standing water: where filling a terrain covered it.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

/// The lakes between a terrain and its filled surface, those of at least min_area_m2, from the largest on: areas named
/// "lake 1", ... with level_m, depth_m (greatest), area_m2 and volume_m3. Linear.
Drawing trace_lakes(const HeightField& terrain, const HeightField& filled, double min_area_m2, const RunContext& run);

}  // namespace seamount::hydrology
