// Craters that somebody drew: hollows at summits that keep their water, while all other land is made to drain.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/geom/scalar/curve.h"
#include "seamount/model/grid.h"
#include "seamount/ops/island/summits.h"

namespace seamount::island {

/// 1 within the craters: of peaks whose profile, or the island's where they have none, is highest away from the summit.
/// Empty where there are none.
Grid<uint8_t> craters(const std::vector<Peak>& peaks, const geom::CurveFunction& profile, const GridFrame& frame);

}  // namespace seamount::island
