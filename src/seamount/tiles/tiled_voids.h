// Holes of a raster in tiles, filled as geom::fill_voids() fills them: found over the tiles' borders, and solved in the
// windows around them.
#pragma once

#include <cstdint>

#include "seamount/base/run_context.h"
#include "seamount/tiles/world.h"

namespace seamount::tiles {

/// Writes the tiles of `from`, terrain, to `to` with their holes filled; those of `to` that are there stay. Returns how
/// many cells were filled. Throws NeedsWhole for a hole whose window does not fit into memory, and where all holes are
/// filled as one; IncompatibleInputs for a raster of which nothing is known. Two looks at each tile; 40 bytes for each
/// cell of a hole's window.
int64_t fill_tiled_voids(const World& world, const StoredRaster& from, const StoredRaster& to, const RunContext& run);

}  // namespace seamount::tiles
