// terrain.resample of a terrain that does not fit into memory, or to a raster that does not: tile by tile.
#pragma once

#include <string>

#include "seamount/tiles/world.h"

namespace seamount::tiles {

std::string resample_refusal(const recipe::Step& step, const recipe::PlannedStep& planned);

/// geom::resample() of a raster that lies at `source`, onto a frame that fits into memory.
HeightField resample_by_rows(const World& world, const OutputOf& from, const GridFrame& source, const GridFrame& target,
                             const RunContext& run);

/// Throws NeedsWhole for a terrain in another coordinate system than the document's.
void run_tiled_resample(World& world, size_t step, const RunContext& run);

}  // namespace seamount::tiles
