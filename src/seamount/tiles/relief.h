// The lowest and the highest cell of a raster in tiles.
#pragma once

#include <optional>

#include "seamount/tiles/world.h"

namespace seamount::tiles {

struct Relief {
  float lowest = 0.0F;
  float highest = 0.0F;
};

/// Nothing if a cell has no value. REQUIRES: it is there, a terrain or a field. Cost: a
/// read, spread over ranks and threads.
std::optional<Relief> relief_of(const World& world, const OutputOf& raster, const RunContext& run);

}  // namespace seamount::tiles
