// A stroke of a brush, as a pen draws it: what all tools that work under a pen have in common.
#pragma once

#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/model/drawn.h"

namespace seamount {

struct Brush {
  Polyline points;
  std::vector<double> pressure;
  double radius_m = 500.0;
  double hardness = 0.0;

  static constexpr auto fields() {
    using P = Brush;
    return std::tuple(
        field(&P::points, "points", "places of the pen, at least one; a spline runs through them"),
        field(&P::pressure, "pressure", "", between(0, 1),
              "how hard the pen was pressed at each point: share of what the stroke does; none: 1"),
        field(&P::radius_m, "radius_m", "m", between(0.01, 1e6), "reach to either side, where the stroke ends"),
        field(&P::hardness, "hardness", "", between(0, 1),
              "0: soft from the middle on; 1: the same all over, with a sharp edge"));
  }
};

}  // namespace seamount
