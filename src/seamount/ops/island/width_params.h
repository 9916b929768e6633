// Widths of an island's regions as somebody gave them (shape.h).
#pragma once

#include <optional>
#include <tuple>

#include "seamount/base/fields.h"

namespace seamount::island {

/// Those that are absent follow from the land's area (natural_widths).
struct GivenWidths {
  std::optional<double> beach_m, lagoon_m, reef_m, slope_m;

  static constexpr auto fields() {
    using P = GivenWidths;
    return std::tuple(field(&P::beach_m, "beach_m", "m", between(0.1, 1e5),
                            "width of the beach, inside the coast; derived from the land's area if absent"),
                      field(&P::lagoon_m, "lagoon_m", "m", between(0.1, 1e6), "width of the lagoon; derived if absent"),
                      field(&P::reef_m, "reef_m", "m", between(0.1, 1e6), "width of the reef; derived if absent"),
                      field(&P::slope_m, "slope_m", "m", between(0.1, 1e6),
                            "width of the slope down to the sea floor; derived if absent"));
  }
};

}  // namespace seamount::island
