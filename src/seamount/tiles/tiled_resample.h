// terrain.resample to larger cells, row by row: a picture of a world, or the ground for what looks at all of it.
#pragma once

#include <string>

#include "seamount/tiles/world.h"

namespace seamount::tiles {

std::string resample_refusal(const recipe::Step& step, const recipe::PlannedStep& planned);

/// The result is in memory as a whole. Throws Error if that does not fit.
void run_tiled_resample(World& world, size_t step, const RunContext& run);

/// A terrain or field on larger cells, as geom::resample() makes it. `source`: where it is taken to lie. REQUIRES: it
/// is there, and the target's cells are larger. Memory: the result and some rows.
HeightField resample_by_rows(const World& world, const OutputOf& from, const GridFrame& source, const GridFrame& target,
                             const RunContext& run);

}  // namespace seamount::tiles
