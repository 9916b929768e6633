// Outputs whose formats write a raster window by window (OutputFormat::write_windows): tiles for engines, meshes in
// tiles. The whole is never in memory.
#pragma once

#include <functional>
#include <string>

#include "seamount/io/provenance.h"
#include "seamount/tiles/world.h"

namespace seamount::tiles {

/// Writes an output so, if its format and its value can be. `prepared` gives what the format wants besides, which is
/// fetched as a whole. Throws what the format throws.
bool write_by_windows(const World& world, const recipe::Output& output, const std::string& path,
                      const io::Provenance& provenance,
                      const std::function<const recipe::Value&(const recipe::Source&)>& prepared,
                      const RunContext& run);

}  // namespace seamount::tiles
