// Pictures of terrains that do not fit: drawn from means over larger cells, which is said. A picture has far fewer
// pixels than such a terrain has cells.
#pragma once

#include <string>

#include "seamount/tiles/world.h"

namespace seamount::tiles {

std::string picture_refusal(const recipe::Step& step, const recipe::PlannedStep& planned);

/// Runs a step of the family render, whose other rasters are brought to the same cells: fields as means, labels by the
/// cell in the middle. At least two cells of the result are left for each of the picture's pixels, as far as they fit.
/// Throws Error if even that does not fit.
void run_reduced_picture(World& world, size_t step, const RunContext& run);

}  // namespace seamount::tiles
