// terrain.mask by depth, which asks what is sea: waters are numbered over the tiles' borders first, then every tile is
// selected on a ground whose hollows are land.
#pragma once

#include <string>

#include "seamount/tiles/world.h"

namespace seamount::tiles {

std::string mask_refusal(const recipe::Step& step, const recipe::PlannedStep& planned);

/// Throws NeedsWhole.
void run_tiled_mask(World& world, size_t step, const RunContext& run);

}  // namespace seamount::tiles
