// terrain.crop of a terrain that does not fit into memory.
#pragma once

#include <string>

#include "seamount/tiles/world.h"

namespace seamount::tiles {

std::string crop_refusal(const recipe::Step& step, const recipe::PlannedStep& planned);

/// Throws NeedsWhole for a terrain in another coordinate system than the document's.
void run_tiled_crop(World& world, size_t step, const RunContext& run);

}  // namespace seamount::tiles
