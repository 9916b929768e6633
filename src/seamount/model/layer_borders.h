// Where the three ground layers of a terrain meet: low, middle, high (P4 sec. 3.4). Read by terrain.layers, by the
// pictures that are drawn in a style, and by splat maps, so that all show the same layers.
#pragma once

#include <optional>
#include <tuple>

#include "seamount/base/fields.h"

namespace seamount {

struct LayerBorders {
  std::optional<double> low_m;
  std::optional<double> low_error_m;
  std::optional<double> high_m;
  std::optional<double> high_error_m;
  bool smooth = true;
  double variation = 0.5;

  static constexpr auto fields() {
    using P = LayerBorders;
    return std::tuple(
        field(&P::low_m, "low_m", "m", between(-12000, 9000),
              "height up to which all is the low layer; by default 0.3 of the relief, over the sea where there is "
              "some, or "
              "as the style asks"),
        field(&P::low_error_m, "low_error_m", "m", between(0, 20000),
              "height above low_m over which the low layer fades; by default 0.1 of the relief"),
        field(&P::high_m, "high_m", "m", between(-12000, 9000),
              "height from which the high layer takes over; by default 0.5 of the relief"),
        field(&P::high_error_m, "high_error_m", "m", between(0, 20000),
              "height below high_m over which the high layer fades in; by default 0.05 of the relief"),
        field(&P::smooth, "smooth", "layers fade in and out softly; off: linearly, as in the paper"),
        field(
            &P::variation, "variation", "", between(0, 1),
            "how far borders stray from one height, by noise and on steep ground, which is more of the middle layer"));
  }
};

}  // namespace seamount
