// Where lakes stand in a climate: each depression is full enough that its lake loses from its surface what comes in, or
// it overflows into the next.
//
// Depressions form a tree (Barnes, Callaghan and Wickert 2020, "Computing water flow through complex landscapes, part
// 2"): two that share their lowest pass are one from that height on. Here not a volume of water is spilled through the
// tree but a yearly flow, until what comes in and what goes off are equal everywhere.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Heights of water in a year.
struct LakeClimate {
  double runoff_mm_yr = 100.0;              ///< that dry ground sends on, >= 0
  const ScalarField* runoff_map = nullptr;  ///< the same for each cell; null: everywhere runoff_mm_yr
  double loss_mm_yr = 900.0;                ///< that a lake's surface loses: evaporation less rain
};

/// A depression that holds a lake, or none for lack of water. Flows are in m3/yr.
struct StandingLake {
  float level_m = 0.0F;  ///< of the water; of the lowest ground where there is none
  float pass_m = 0.0F;   ///< where it would overflow
  int32_t pit = -1;      ///< its lowest cell
  bool closed = false;   ///< no water leaves but from its surface
  int64_t cells = 0;     ///< under water
  double inflow = 0.0;   ///< from the dry ground of its catchment and from lakes that overflow into it
  double outflow = 0.0;  ///< over the pass
};

struct LakeLevels {
  std::vector<StandingLake> lakes;  ///< in the order in which a scan meets their pits
  Grid<int32_t> lake;               ///< index of the lake that covers a cell; -1: dry
};

/// Water covers whole cells: a closed lake stands at the height of the lowest ground around it that it cannot keep wet.
/// No lake loses less than the runoff of its dry bed would bring: where runoff + loss < 0 it counts as 0. Without
/// losses lakes are those of fill_depressions(). Heights must be finite but for kUnknownGround; cells at or below the
/// sea level end flow, as does the border. Parallel but for sorting the cells of depressions and for the tree; n log n;
/// 9 bytes per cell and 8 per cell of depressions besides the result.
LakeLevels lake_levels(const HeightField& terrain, float sea_level_m, const LakeClimate& climate,
                       const RunContext& run);

}  // namespace seamount::geom
