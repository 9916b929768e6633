// Which way the reef faces: to windward, where the swell breaks, or to leeward.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::island {

/// Cosine between the way out to sea and the way to where the swell comes from, on a lattice of at most 256 nodes a
/// side: 1 to windward, -1 to leeward, smooth over `smooth_m`; 0 where there is no way out.
ScalarField exposure(const ScalarField& coordinate, double swell_from_deg, double smooth_m, const RunContext& run);

}  // namespace seamount::island
