// Parameters of glacier.run (run.h).
#pragma once

#include <tuple>

#include "seamount/base/fields.h"

namespace seamount::glacier {

struct RunParams {
  double years = 100000;
  double ela_m = 1800;
  double balance_gradient_m_yr_km = 7;
  double max_accumulation_m_yr = 1.5;
  double abrasion = 1e-4;
  double widening_m = 100;
  double wall_angle_deg = 55;

  static constexpr auto fields() {
    using P = RunParams;
    return std::tuple(
        field(&P::years, "years", "yr", between(0, 1e7),
              "how long glaciers carve; 0 shows the ice on the terrain as it is"),
        field(&P::ela_m, "ela_m", "m", between(-12000, 12000),
              "equilibrium line: height above which more snow falls in a year than melts"),
        field(
            &P::balance_gradient_m_yr_km, "balance_gradient_m_yr_km", "m/yr/km", between(0.1, 50),
            "ice gained or lost per year for each kilometre over or under the equilibrium line; 3 dry, 7 Alps, 15 wet"),
        field(&P::max_accumulation_m_yr, "max_accumulation_m_yr", "m/yr", between(0.01, 20),
              "most ice that a year's snow makes"),
        field(&P::abrasion, "abrasion", "", between(0, 0.01),
              "metres of bed that are carved for each metre that ice slides; hard rock 1e-5, soft 1e-3"),
        field(&P::widening_m, "widening_m", "m", between(0, 5000),
              "how far to the sides of its fastest ice a glacier carves: floors of valleys become wide and flat"),
        field(&P::wall_angle_deg, "wall_angle_deg", "deg", between(10, 89),
              "steepest wall that stands over carved ground; what is steeper falls onto the ice"));
  }
};

}  // namespace seamount::glacier
