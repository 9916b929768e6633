// How open to the sea each place of a map is.
#pragma once

#include <cstdint>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::classify {

/// Share of 16 directions in which a cell looks over open water: the distance to the nearest barrier (a cell with
/// barrier != 0) reaches fetch_m, fading to none at half of it; beyond the frame's edge the way is open. A barrier's
/// own cell does not count for itself. Linear in cells, parallel over directions.
ScalarField exposure(const Grid<uint8_t>& barrier, double fetch_m, const RunContext& run);

}  // namespace seamount::classify
