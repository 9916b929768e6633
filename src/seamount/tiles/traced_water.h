// Lakes and catchments of a raster in tiles as areas: found over the tiles' borders, and traced one by one in the
// windows around them. All ranks find them, and rank 0 alone traces them and gets the areas.
#pragma once

#include <memory>

#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/tiles/drainage.h"

namespace seamount::tiles {

/// hydrology::trace_lakes() of what was filled, before it was tilted. Throws Error for a lake whose window does not fit
/// into memory.
Drawing trace_tiled_lakes(const World& world, const Drainage& water, double min_area_m2, const RunContext& run);

/// hydrology::trace_catchments() of what was numbered. `basins`: the numbers on disk. Throws as above.
Drawing trace_tiled_catchments(const World& world, const Drainage& water, const StoredRaster& basins,
                               double min_area_m2, const RunContext& run);

}  // namespace seamount::tiles
