// Values that have a place, in another coordinate system or on other cells.
//
// Nothing here guesses: both systems must be known. Heights stay as they are.
#pragma once

#include <string>

#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/extent.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"
#include "seamount/model/tin.h"

namespace seamount::io {

/// Every point in the other system; straight edges stay straight there. A frame becomes the upright one around it, with
/// the same cells. Throws InvalidArgument{"crs"} for text that is no system, and for places outside of it. Linear.
Drawing in_system(Drawing drawing, const std::string& crs);
ContourSet in_system(ContourSet contours, const std::string& crs);
Tin in_system(Tin tin, const std::string& crs);

/// The upright rectangle around an extent in the other system. Throws as above.
Extent in_system(const Extent& extent, const std::string& crs);

/// The raster on upright cells of the other system, of the same size, that cover all of it; NaN, or abyss, beyond its
/// own edge. Bilinear, categories by the nearest cell. Throws as above, and for more than 2^30 cells. Serial.
Grid<float> in_system(const Grid<float>& grid, const std::string& crs, const RunContext& run);
LabelMap in_system(const LabelMap& labels, const std::string& crs, const RunContext& run);

/// The raster on the cells of a frame, which may lie in another system: averages where those are twice as large or
/// more, else bilinear; categories by the nearest cell. NaN, or abyss, outside of the raster and where less than half
/// of the weight has a value. A raster on the same lattice comes over exactly. Serial.
Grid<float> on_cells(const Grid<float>& grid, const GridFrame& frame, const RunContext& run);
LabelMap on_cells(const LabelMap& labels, const GridFrame& frame, const RunContext& run);

}  // namespace seamount::io
