// The last touch of island.build: summits stand as high as they were asked for.
#pragma once

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/island/summits.h"

namespace seamount::island {

/// Brings the highest cell to the height of the highest peak, and the highest cell beside every peak that somebody
/// placed to its height, to float rounding. Land that is too high is pressed down evenly from three quarters of the
/// height on, around placed peaks to below them; the ground around a summit that is too low is scaled up
/// smoothly towards its highest cell, over as far as the land around it reaches. Says where a placed peak stands on the
/// slope of a higher one. A few passes over the cells, parallel.
void set_peak_heights(HeightField& terrain, const std::vector<Peak>& peaks, const RunContext& run);

}  // namespace seamount::island
