// Gauss-Seidel sweeps over the cells of transport_level.h.
#pragma once

#include "seamount/geom/solve/transport_level.h"

namespace seamount::geom::transport {

/// Two sweeps each: rows from north to south (or back), cells in them first eastwards, then westwards. A flow in any
/// direction is followed by one of the four. `held`: values stay at 0 or above (projected sweeps). The bits are those
/// of cell after cell in that order.
void sweep_south(Level& level, bool held);
void sweep_north(Level& level, bool held);

}  // namespace seamount::geom::transport
