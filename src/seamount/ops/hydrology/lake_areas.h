// Standing water as areas.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

struct LakeArea {
  std::vector<int32_t> cells;
  double level_m = 0.0;
  double depth_m = 0.0;   ///< greatest
  double volume_m = 0.0;  ///< sum of the depths of its cells
  Attributes more;        ///< attributes of its own
};

/// From the largest lake on, of equal ones in their order: areas named "lake 1", ... with level_m, depth_m, area_m2,
/// volume_m3 and what a lake has of its own. Linear in the cells and in the windows of the lakes.
Drawing draw_lakes(std::vector<LakeArea> lakes, const GridFrame& frame, const RunContext& run);

/// The cells of one level that hang together by their sides, found by walking from the first of them, all of which are
/// `seen` then: a lake between a terrain and its filled surface.
LakeArea walk_lake(const HeightField& terrain, const HeightField& filled, int32_t first, Grid<uint8_t>& seen);

/// The area of a lake as draw_lakes() makes it.
NamedArea lake_area(const LakeArea& lake, size_t number, std::vector<Polygon> shore, double cell_m);

/// The lakes between a terrain and its filled surface, those of at least min_area_m2. Linear.
Drawing trace_lakes(const HeightField& terrain, const HeightField& filled, double min_area_m2, const RunContext& run);

}  // namespace seamount::hydrology
