// Flow that one neighbour alone does not take: between two of them (D-infinity, Tarboton 1997) or over all lower ones
// (multiple flow direction, Freeman 1991, Holmgren 1994). Level ground drains as D8 does.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

/// Direction of steepest descent over the eight triangular facets around a cell, in eighths of a turn counter-clockwise
/// from east, [0, 8]; a whole number where one neighbour takes all. -1 where `d8` says that flow ends, the direction of
/// `d8` where no facet falls. Tarboton 1997, eq. 1 to 5 and table 1. Parallel.
ScalarField dinf_directions(const HeightField& filled, const geom::FlowDirections& d8, float sea_level_m,
                            const RunContext& run);

/// Cells, in parts, whose water passes through each cell when it is shared between the two neighbours on either side of
/// the D-infinity direction in inverse proportion to the angle. Parallel.
ScalarField dinf_accumulation(const ScalarField& directions, const geom::FlowDirections& d8, const RunContext& run);

/// The same when it is shared over all lower neighbours in proportion to slope^exponent (Holmgren 1994, eq. 1).
/// Parallel.
ScalarField mfd_accumulation(const HeightField& filled, const geom::FlowDirections& d8, float sea_level_m,
                             double exponent, const RunContext& run);

}  // namespace seamount::hydrology
