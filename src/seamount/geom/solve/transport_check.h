// What is asked of a problem of transport.h before it is solved.
#pragma once

#include "seamount/geom/solve/transport.h"
#include "seamount/geom/solve/transport_level.h"

namespace seamount::geom::transport {

/// Throws InvalidArgument for numbers that are none and IncompatibleInputs for other sizes, as steady_state says.
void check_transport(const Transport& transport);

/// Throws InvalidArgument where material would gather for ever: without decay and diffusion, in cells from which
/// nothing flows to the border or to a cell that absorbs. `finest`: the problem's cells.
void check_outflow(const Level& finest, const Transport& transport);

}  // namespace seamount::geom::transport
