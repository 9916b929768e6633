// hydrology.lakes: lakes as a climate leaves them, with outlet and without.
//
// What hydrology.fill covers is what water could cover. In a dry climate a lake evaporates what comes in before it is
// full (the Dead Sea, Great Salt Lake, Issyk-Kul): its surface is as large as its catchment's runoff can keep up. Each
// depression's lake stands where inflow and evaporation are equal, or overflows into the next
// (geom/water/lake_levels.h).
#pragma once

#include <optional>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

struct LakesParams {
  double runoff_mm_yr = 100.0;
  double rain_mm_yr = 400.0;
  double evaporation_mm_yr = 1200.0;
  double min_depth_m = 5.0;
  double min_lake_m2 = 20000.0;
  bool sea = true;
  std::optional<double> min_sea_m2;

  static constexpr auto fields() {
    using P = LakesParams;
    return std::tuple(
        field(&P::runoff_mm_yr, "runoff_mm_yr", "mm/yr", between(0, 20000),
              "rain on dry ground that runs off, in a year; the input runoff says it for each cell"),
        field(&P::rain_mm_yr, "rain_mm_yr", "mm/yr", between(0, 20000), "rain that falls on a lake in a year"),
        field(&P::evaporation_mm_yr, "evaporation_mm_yr", "mm/yr", between(0, 1e6),
              "what a lake's surface loses to the air in a year: 600 in cool, 1200 in temperate dry, 2500 in hot dry "
              "places; 0 fills all lakes to their outlets"),
        field(&P::min_depth_m, "min_depth_m", "m", between(0, 10000),
              "depressions that are less deep count as roughness of the ground, full and without a lake"),
        field(&P::min_lake_m2, "min_lake_m2", "m2", between(0, 1e12), "smaller lakes are not traced"),
        field(&P::sea, "sea", "flow ends in cells at or below sea level; otherwise only at the terrain's edge"),
        field(&P::min_sea_m2, "min_sea_m2", "m2", between(0, 1e15), geom::kLeastSeaMeaning));
  }
};

struct Lakes {
  HeightField surface;  ///< of the ground and of the lakes
  ScalarField depth_m;  ///< of the water; 0 where there is no lake
  ScalarField sinks;    ///< 1 where flow ends: in closed lakes, and on the lowest ground of dry depressions
  /// Areas "lake 1", ... from the largest on, with level_m, depth_m (greatest), area_m2, volume_m3, closed (1: no water
  /// leaves but into the air, so that salt gathers; 0: it overflows), inflow_m3_s and outflow_m3_s.
  Drawing lakes;
};

/// `runoff` in mm/yr may be null. Of a closed lake inflow = (evaporation - rain) x area as closely as whole cells
/// allow: with the cells at the height of its level it would lose more than comes in. Cells of which nothing is known
/// (NaN) end flow, and stay so. Throws InvalidArgument for params out of range and for runoff that is negative or no
/// number, IncompatibleInputs for runoff of another size. Cost as geom::lake_levels().
Lakes lakes(const HeightField& terrain, const ScalarField* runoff, const LakesParams& params, const RunContext& run);

}  // namespace seamount::hydrology
