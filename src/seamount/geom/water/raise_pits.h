// Broad pits of a height field raised to plains that drain, as sediment fills a valley behind a sill.
#pragma once

#include <cstdint>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// On a lattice of at most `side` nodes a side, each the lowest of its cells, land that cannot drain is raised until it
/// falls towards the sea by at least `slope` (priority flood with a gradient, after Barnes, Lehman and Mulla 2014), and
/// the smooth difference is added to the terrain above `sea_level_m`. Lowers nothing. What remains are pits smaller
/// than a lattice cell (breach.h). The grid's border drains, and so do cells where `basins` (empty: none) is not 0.
/// Linear in the cells, n log n in the lattice's land.
void raise_pits(HeightField& terrain, float sea_level_m, double slope, int side, const Grid<uint8_t>& basins,
                const RunContext& run);

}  // namespace seamount::geom
