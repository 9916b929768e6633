// hydrology.rivers and hydrology.ridges: networks as lines.
//
// Rivers are the links of the D8 network on the filled terrain (network.h). Discharge is area x runoff; width grows
// with its square root (Leopold and Maddock 1953). Ridges are the rivers of the inverted terrain (P1 sec. 5.1): there
// summits are pits, and filling them would drown the ridges, so the way runs on from each summit over its highest pass
// to a higher one (geom::route_through_pits), and ends on the highest of each piece of land.
#pragma once

#include <array>
#include <optional>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

struct RiversParams {
  std::optional<double> min_area_m2;
  double runoff_mm_yr = 500.0;
  double width_factor = 6.0;
  bool sea = true;
  std::optional<double> min_sea_m2;

  static constexpr auto fields() {
    using P = RiversParams;
    return std::tuple(
        field(&P::min_area_m2, "min_area_m2", "m2", between(1, 1e13),
              "catchment with which a river begins; a five-hundredth of the land if absent"),
        field(&P::runoff_mm_yr, "runoff_mm_yr", "mm/yr", between(0, 20000), "rain that runs off, in a year"),
        field(&P::width_factor, "width_factor", "", between(0, 100),
              "width in metres of a river of 1 m3/s; it goes with the square root of discharge"),
        field(&P::sea, "sea", "flow ends in cells at or below sea level; otherwise only at the terrain's edge"),
        field(&P::min_sea_m2, "min_sea_m2", "m2", between(0, 1e15), geom::kLeastSeaMeaning));
  }

  static constexpr std::array kFormerNames = {FormerName{"least_sea_m2", "min_sea_m2"}};
};

struct RidgesParams {
  std::optional<double> min_area_m2;
  bool sea = true;
  std::optional<double> min_sea_m2;

  static constexpr auto fields() {
    using P = RidgesParams;
    return std::tuple(field(&P::min_area_m2, "min_area_m2", "m2", between(1, 1e13),
                            "ground whose ways up join before a ridge begins; a five-hundredth of the land if absent"),
                      field(&P::sea, "sea", "ridges stand on cells above sea level; otherwise everywhere"),
                      field(&P::min_sea_m2, "min_sea_m2", "m2", between(0, 1e15), geom::kLeastSeaMeaning));
  }

  static constexpr std::array kFormerNames = {FormerName{"least_sea_m2", "min_sea_m2"}};
};

/// One line per reach between confluences, downstream, tributaries first. Its value is the Strahler order; it carries
/// order, length_m, area_m2, discharge_m3_s, width_m and fall_m at its lower end. From point to point the filled
/// terrain never climbs. Rivers end where `sinks` (may be null) is above 0, as in the closed lakes of hydrology.lakes.
/// Throws InvalidArgument for params out of range, IncompatibleInputs for sinks of another size. About the cost of
/// hydrology.flow.
Drawing rivers(const HeightField& terrain, const ScalarField* sinks, const RiversParams& params, const RunContext& run);
/// Without sinks.
inline Drawing rivers(const HeightField& terrain, const RiversParams& params, const RunContext& run) {
  return rivers(terrain, nullptr, params, run);
}

/// One line per reach, from the ridge's foot up; value and order as above, with length_m, area_m2 (of the ground whose
/// ways up pass there) and rise_m (from the line's start to its end).
Drawing ridges(const HeightField& terrain, const RidgesParams& params, const RunContext& run);

}  // namespace seamount::hydrology
