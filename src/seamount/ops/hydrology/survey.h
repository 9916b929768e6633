// Everything that hydrology.describe measures on one terrain.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/hydrology/bearings.h"
#include "seamount/ops/hydrology/channel_slopes.h"
#include "seamount/ops/hydrology/distribution.h"
#include "seamount/ops/hydrology/peaks.h"

namespace seamount::hydrology {

/// What both terrains of a comparison share.
struct SurveyPlan {
  float sea_level_m = 0.0F;
  double relief_window_m = 1000.0;  ///< side of the square of local relief
  double channel_m2 = 1e6;          ///< catchment with which a river, or a ridge, begins
  double min_prominence_m = 30.0;
};

/// Height difference over a distance: the root of its mean square along rows and columns.
struct Unevenness {
  double lag_m, rms_m;
};

/// What lies above the sea.
struct Land {
  double cell_m2 = 0.0;
  int64_t of_cells = 0;  ///< of the terrain
  int64_t cells = 0;
  float low_m = 0.0F, high_m = 0.0F;  ///< 0 without land
};

/// Without land: empty, with nothing counted.
struct Survey {
  double cell_m = 0.0;
  double relief_window_m = 0.0;                            ///< as whole cells make it
  Distribution elevation, slope, curvature, relief, area;  ///< slope in degrees; area: log10 of square metres
  Bearings aspect;
  ChannelSlopes channels;
  std::vector<int> streams;  ///< of the river network by Strahler order, from 1 on
  double river_m = 0.0, ridge_m = 0.0;
  std::vector<Peak> peaks;
  std::vector<Unevenness> unevenness;  ///< lags of 1, 2, 4, ... cells
  double land_m2 = 0.0;

  bool has_land() const { return land_m2 > 0.0; }
};

Land find_land(const HeightField& terrain, float sea_level_m);

/// What it finds depends on the terrain and the plan alone; geom::kUnknownGround is no land. Parallel; 22 bytes per
/// cell besides.
Survey survey(const HeightField& terrain, const SurveyPlan& plan, const RunContext& run);

}  // namespace seamount::hydrology
