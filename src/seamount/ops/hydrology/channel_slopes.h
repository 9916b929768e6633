// How steep rivers are for the ground that they drain: slope ~ area^-concavity (Flint 1974).
//
// Slopes of the surface do not show it: banks are in them. Here a slope is the fall along the flow path over the way on
// which it falls by a fixed height, as channels are read from contour lines (Snyder et al. 2000, Wobus et al. 2006,
// sec. 2.2), which the steps of an elevation model do not disturb. Along each river such reaches follow each other from
// its head to where it joins one that drains more. Below 1 km2 there are hollows and debris flows, not rivers.
#pragma once

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

/// Mean slope along the flow where about this much ground drains.
struct SlopeOfArea {
  double area_m2, slope;  ///< slope: fall over way, of a quarter of a decade of area
};

struct ChannelSlopes {
  std::vector<SlopeOfArea> curve;  ///< ascending in area, from single cells on
  double concavity = 0.0;          ///< of the rivers from from_m2 on; not a number where they span too little
  double from_m2 = 0.0;            ///< 1 km2; less where no river drains ten times that, but 16 cells at least
};

/// `directions` and `cells` (accumulation) of `filled`, which is `terrain` without depressions; of cells of the terrain
/// above the sea. Reaches fall by 20 m, or a fiftieth of the relief where that is less. Linear; no memory to speak of.
ChannelSlopes channel_slopes(const HeightField& terrain, const HeightField& filled,
                             const geom::FlowDirections& directions, const Grid<uint32_t>& cells, float sea_level_m,
                             const RunContext& run);

}  // namespace seamount::hydrology
