// A triangulated network as a raster.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/tin.h"

namespace seamount::geom {

/// Heights at cell centres by linear interpolation within triangles; cells that no triangle covers fall gently and
/// smoothly from those that one does (solve/extrapolation.h). REQUIRES: find_tin_defect() finds nothing, heights for
/// all nodes. Throws IncompatibleInputs where no triangle covers any cell. Linear in cells and triangles; parallel but
/// for the sorting of triangles into rows.
HeightField rasterise_tin(const Tin& tin, const GridFrame& frame, const RunContext& run);

/// Nodes within the border of the network that no neighbour is lower than: where its water may stay. Ascending. Linear.
std::vector<int32_t> find_low_nodes(const Tin& tin, const RunContext& run = {});

}  // namespace seamount::geom
