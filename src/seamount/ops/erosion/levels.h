// From a coarse ground to a finer one: what erosion did at cells of 2 c goes on at cells of c.
//
// Large valleys need long times and few cells, small ones short times and many. So a run begins on a coarse grid and
// moves to finer ones as the years go by. A finer grid takes over the change since the start, smoothly interpolated and
// corrected so that each block of 2 x 2 cells keeps the mean of its parent; and the detail of the start that the coarse
// grid could not hold, as far as the ground that bore it is still there: it fades out with the depth of what was eroded
// or laid on it. A parent at an odd edge lies partly off the map, and outlets of the border stay where they are: what
// changed there counts as having left the map.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/ops/erosion/ground.h"

namespace seamount::erosion {

/// Means of 2 x 2 cells of each layer and map.
Ground halved(const Ground& ground, const RunContext& run);
Site halved(const Site& site, const RunContext& run);

/// Carries the change from `start` to `now` over to `fine`, of which `start` is the halved one, and whose site is
/// `site`: nothing changes where its mask is 0, and `pinned` cells (1) keep their height. Adds to ledger.exported what
/// the fine ground could not take over. Parallel; two more grids of memory.
void refine(const Ground& now, const Ground& start, Ground& fine, const Site& site, const Grid<uint8_t>& pinned,
            Ledger& ledger, const RunContext& run);

}  // namespace seamount::erosion
