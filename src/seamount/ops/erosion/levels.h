// From a coarse ground to a finer one: what erosion did at cells of 2 c goes on at cells of c.
//
// Large valleys need long times and few cells, small ones short times and many. So a run begins on a coarse grid and
// moves to finer ones as the years go by. A finer grid takes over the ground smoothly interpolated, and bent: each
// place is read half a coarse cell beside itself, by the curl of a noise, or else the valleys that ran along rows,
// columns and diagonals of the coarse grid would do so for ever, and straight. Where nothing changed nothing is bent.
// The detail of the start that the coarse grid could not hold stays as far as the ground that bore it is still there:
// it fades out with the depth of what was eroded or laid on it. Curls keep volumes nearly, and what is missing is made
// up where ground changed; a parent at an odd edge lies partly off the map, and what changed there counts as having
// left it. Outlets of the border stay where they are.
#pragma once

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/ops/erosion/layers.h"

namespace seamount::erosion {

/// Means of 2 x 2 cells of each layer and map.
Layers halved(const Layers& ground, const RunContext& run);
Maps halved(const Maps& site, const RunContext& run);

/// Carries the change from `start` to `now` over to `fine`, of which `start` is the halved one, and whose maps are
/// `site`: nothing changes where its mask is 0, and `pinned` cells (1) keep their height. `seed` draws the
/// bends. Adds to ledger.exported what the fine ground could not take over. Parallel, about 60 ns per cell; one more
/// grid of memory.
void refine(const Layers& now, const Layers& start, Layers& fine, const Maps& site, const Grid<uint8_t>& pinned,
            Seed seed, Ledger& ledger, const RunContext& run);

}  // namespace seamount::erosion
