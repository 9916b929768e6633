// Runs a recipe whose rasters are larger than memory, tile by tile (ADR 16).
//
// Steps that look at their own place or at a neighbourhood are run by windows, chains of them at once; steps that look
// at everything get it as a whole, as long as that fits into the memory that may be used. Results have the bytes of
// execute(), whatever the size of the tiles.
#pragma once

#include "seamount/recipe/executor.h"
#include "seamount/tiles/options.h"

namespace seamount::tiles {

/// As recipe::execute(), whose reports and messages it gives. Terrains, fields and labels that are written to .tif go
/// there row by row, with overviews; what is written otherwise must fit into memory. Tiles lie in a folder "tiles" of
/// the cache: a run that was stopped or killed goes on with what the one before has made, and removes them at its end.
/// With options.ranks every rank calls it; rank 0 reports, and says what operators say.
/// Throws Error for a step or an output that does not fit, with what to do instead.
recipe::ExecuteReport execute(const recipe::Recipe& recipe, const TileOptions& options, const RunContext& run);

}  // namespace seamount::tiles
