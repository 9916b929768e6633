// Parameters of reef.grow that say where a reef starts and where it may grow (habitat.h). Heights are metres about sea
// level.
#pragma once

#include <optional>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/model/drawn.h"

namespace seamount::reef {

/// Where growth starts. Each place that is so found becomes a kernel: the first colonies.
struct StartParams {
  Polyline points;
  Polyline line;
  std::optional<double> contour_m;
  double line_cover = 0.7;
  double segment_m = 2500.0;
  int random = 0;

  static constexpr auto fields() {
    using P = StartParams;
    return std::tuple(
        field(&P::points, "points", "m", {},
              "places where growth starts; without any start each separate piece of habitat has one"),
        field(&P::line, "line", "m", {}, "a line along which growth starts, such as a shelf edge"),
        field(&P::contour_m, "contour_m", "m", between(-12000, 9000), "growth starts along the contour at this height"),
        field(&P::line_cover, "line_cover", "", between(0, 1),
              "share of lines where growth starts; the rest are passes"),
        field(&P::segment_m, "segment_m", "m", between(1, 1e7), "length of a stretch of line with its pass"),
        field(&P::random, "random", "", between(0, 100000),
              "number of random places of the habitat, or of the input 'start': many small reefs, few large"));
  }
};

/// Where particles may settle.
struct BoundParams {
  double light_depth_m = 40.0;
  std::optional<double> low_m;
  std::optional<double> high_m;
  std::optional<double> margin_m;

  static constexpr auto fields() {
    using P = BoundParams;
    const Range height = between(-12000, 9000);
    return std::tuple(
        field(&P::light_depth_m, "light_depth_m", "m", between(1, 200),
              "depth at which a tenth of the light is left, which corals need: 60 in the clearest ocean, 40 in clear "
              "water, 25 over shelves, 10 off muddy rivers"),
        field(&P::low_m, "low_m", "m", height,
              "no growth where the ground is lower; if absent, below light_depth_m (heights.mode proportional: none)"),
        field(&P::high_m, "high_m", "m", height,
              "no growth where the ground is higher; if absent, the sea's surface (heights.mode proportional: none)"),
        field(&P::margin_m, "margin_m", "m", between(0, 1e7),
              "no growth this near to the terrain's edge, in bays up to twice that; 3 kernel radii if absent"));
  }
};

}  // namespace seamount::reef
