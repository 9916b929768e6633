// A summit as somebody gave it (summits.h).
#pragma once

#include <optional>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/model/drawn.h"

namespace seamount::island {

struct Summit {
  Vec2 place;
  std::optional<double> height_m;
  Curve profile;

  static constexpr auto fields() {
    using P = Summit;
    return std::tuple(
        field(&P::place, "place", "where it stands, on land"),
        field(&P::height_m, "height_m", "m", between(1, 9000),
              "height of the summit; that of an island as wide as the land around it if absent"),
        field(&P::profile, "profile", "", between(0, 2),
              "share of the summit's height over 0 (the summit) to 1 (foot of the mountains): a cone, a plateau, a "
              "crater; that of the island if empty"));
  }
};

}  // namespace seamount::island
