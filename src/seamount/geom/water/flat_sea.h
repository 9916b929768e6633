// Land elevation models give the sea as 0 everywhere. Pictures and labels of them need to know where that is, and some
// floor.
#pragma once

#include <cstdint>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// 1 at cells that are 0 exactly, as are all their neighbours: sea of unknown depth. An empty grid where that is less
/// than a hundredth of the terrain (such cells are then taken as they are).
Grid<uint8_t> flat_sea(const HeightField& terrain, const RunContext& run);

/// The same up to its coast: with the cells of 0 that touch it.
Grid<uint8_t> flat_sea_to_coast(const HeightField& terrain, const RunContext& run);

/// Gives the flat sea a plausible floor, some 100 metres deep, falling with the distance from the coast.
void sink_flat_sea(HeightField& terrain, const Grid<uint8_t>& sea, const RunContext& run);

}  // namespace seamount::geom
