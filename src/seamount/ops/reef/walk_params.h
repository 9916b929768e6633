// Parameters of the walks of reef.grow: how particles come to the reef (aggregate.h).
#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "seamount/base/fields.h"

namespace seamount::reef {

/// Where walks start: on a circle around the aggregate, or in any free cell of the lattice (P4).
enum class Launch { ring, anywhere };

struct WalkParams {
  double stickiness = 1.0;
  Launch launch = Launch::anywhere;
  double current = 0.0;
  double current_to_deg = 300.0;
  int max_steps = 200000;

  static constexpr auto fields() {
    using P = WalkParams;
    return std::tuple(
        field(&P::stickiness, "stickiness", "", between(0.001, 1),
              "chance to settle at a touch; low values give thick, rounded reefs"),
        field(&P::launch, "launch", "where walks start: on a ring around the reef, or anywhere on the lattice"),
        field(&P::current, "current", "", between(0, 1), "how strongly currents carry the particles"),
        field(&P::current_to_deg, "current_to_deg", "deg", between(-360, 360), "bearing to which currents flow"),
        field(&P::max_steps, "max_steps", "", between(1, 1000000000), "steps after which a walk is given up"));
  }
};

}  // namespace seamount::reef

template <>
struct seamount::Choices<seamount::reef::Launch> {
  static constexpr std::array<std::string_view, 2> names = {"ring", "anywhere"};
};
