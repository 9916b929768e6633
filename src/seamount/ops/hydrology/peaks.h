// Summits with prominence and isolation: how far one has to descend, and how far to go, to reach higher ground.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

struct Peak {
  int32_t cell = 0;  ///< row * width + column
  double height_m = 0.0;
  double prominence_m = 0.0;  ///< over the highest pass to higher ground; a land's highest summit: over its lowest cell
  double isolation_m = 0.0;   ///< to the nearest cell that is higher; of the highest, the frame's diagonal
};

/// Summits (cells or level ground without higher neighbours) above the sea of at least min_prominence_m, from the most
/// prominent on. Summits whose level ground touches the frame are left out: how they go on beyond is not known.
/// Prominence by joining the catchments of the inverted terrain at their passes, from the highest on
/// (geom/water/flow_passes.h); isolation by a search through a pyramid of maxima. Linear, and n log n in the passes.
std::vector<Peak> find_peaks(const HeightField& terrain, float sea_level_m, double min_prominence_m,
                             const RunContext& run);

}  // namespace seamount::hydrology
