// Everything that hydrology.describe measures on one terrain.
#pragma once

#include <utility>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/hydrology/histogram.h"
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

/// Mean slope of the cells with about this catchment.
struct SlopeOfArea {
  double area_m2, slope;  ///< slope: rise over run, mean over a quarter of a decade of area
};

struct Survey {
  Histogram elevation{0, 1, 1}, slope{0, 1, 1}, aspect{0, 1, 1}, curvature{0, 1, 1}, relief{0, 1, 1}, area{0, 1, 1};
  std::vector<SlopeOfArea> slope_of_area;
  std::vector<int> streams;  ///< of the river network by Strahler order, from 1 on
  double river_m = 0.0, ridge_m = 0.0;
  std::vector<Peak> peaks;
  std::vector<Unevenness> unevenness;  ///< lags of 1, 2, 4, ... cells
  double land_m2 = 0.0;
  double low_m = 0.0, high_m = 0.0;  ///< of the land
};

/// Bounds of histograms that depend on the terrains.
struct SurveyBounds {
  double low_m = 0.0, high_m = 1.0;  ///< of elevation, and of local relief from 0
  double curvature = 1.0;            ///< largest, 1/m, to either side
  double area_m2 = 1.0;              ///< largest catchment
};

/// Lowest and highest land. {0, 0} without land.
std::pair<double, double> land_range(const HeightField& terrain, float sea_level_m);

/// Deviation of the mean curvature of the land, 1/m.
double curvature_deviation(const HeightField& terrain, float sea_level_m, const RunContext& run);

/// Land is what lies above the sea. Parallel; 40 bytes per cell.
Survey survey(const HeightField& terrain, const SurveyPlan& plan, const SurveyBounds& bounds, const RunContext& run);

}  // namespace seamount::hydrology
