// terrain.import of a GeoTIFF that does not fit into memory: read window by window.
#pragma once

#include <optional>
#include <string>

#include "seamount/tiles/world.h"

namespace seamount::tiles {

std::string import_refusal(const recipe::Step& step, const recipe::PlannedStep& planned);

/// The size that the file's raster has as it is stored, which is about what it becomes; nothing
/// of what is no GeoTIFF. Throws IoError.
std::optional<GridFrame> import_size(const World& world, size_t step);

void run_tiled_import(World& world, size_t step, const RunContext& run);

}  // namespace seamount::tiles
