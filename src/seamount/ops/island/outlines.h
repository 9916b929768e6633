// island.outlines: from a label map back to the outlines that island.build reads.
//
// Source: P0 sec. 1.4.1 (the outlines of fig. 1.23), the other way round.
#pragma once

#include <array>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/label_map.h"

namespace seamount::island {

struct OutlinesParams {
  double tolerance_m = 0.0;
  double min_area_m2 = 0.0;

  static constexpr auto fields() {
    using P = OutlinesParams;
    return std::tuple(field(&P::tolerance_m, "tolerance_m", "m", between(0, 1e5),
                            "how far simplified outlines may lie from the traced ones; 0: one quarter cell"),
                      field(&P::min_area_m2, "min_area_m2", "m2", between(0, 1e12),
                            "parts and holes smaller than this are left out"));
  }

  static constexpr std::array kFormerNames = {FormerName{"smallest_m2", "min_area_m2"}};
};

/// The areas inside the outlines of mountain, beach, lagoon and reef, nested, in the labels' coordinates; areas that do
/// not occur are left out. Lies within one cell of the labels' borders. Linear in cells.
Drawing outlines(const LabelMap& labels, const OutlinesParams& params, const RunContext& run);

}  // namespace seamount::island
