// Where the water of a network stays, in a raster of it. Not part of the public interface.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/tin.h"

namespace seamount::contour {

/// Cells (row * width + column), ascending, in which water of a raster of the network may stay: the sinks that one
/// comes to going down from its low nodes, and the lowest cell of each hollow, which may be another one where cells are
/// about as large as triangles: all of a hollow would drain to it over its rim. Linear where there are no hollows, else
/// n log n.
std::vector<int64_t> sinks_of(const Tin& tin, const HeightField& heights, const RunContext& run);

}  // namespace seamount::contour
