// Pits of a height field breached: every place of the land gets a way down to the sea.
//
// For fields that drain but for noise. Pits are taken from the lowest to the highest; from each the cheapest way to
// lower ground is looked for (priority flood, Barnes, Lehman and Mulla 2014) and a notch is cut along it, no
// lower than the pit (Lindsay 2016).
#pragma once

#include <cstdint>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Afterwards no cell above `sea_level_m` lies in a depression: fill_depressions changes nothing. The grid's border
/// drains, and so do cells where `basins` (empty: none) is not 0: depressions that are meant, which stay. Linear in the
/// cells, and n log n in the cells of the depressions; one byte per cell.
void breach_pits(HeightField& terrain, float sea_level_m, const Grid<uint8_t>& basins, const RunContext& run);

}  // namespace seamount::geom
