// Filling an outline with new ground that is like its surroundings (P2 sec. 6.6).
//
// Inside a contour the ground grows inward from it as in P2 sec. 4.2, here as a front whose speed is noise (what Open
// Eden Growth becomes on ever finer networks): fast places become valleys, and each place is reached after a neighbour
// of its, so no basin comes about. Its heights are the quantiles of what other contours of that height enclose, the
// nearest first; where there are none, of what was there before.
//
// Within a polygon that crosses contours the ground is stretched smoothly over it, displaced and roughened as much as
// its surroundings are, and bent to their distribution of heights; then basins are filled.
#pragma once

#include <string>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"
#include "seamount/ops/contour/edit/pattern.h"
#include "seamount/ops/contour/edit/tools.h"

namespace seamount::contour {

/// Throws InvalidArgument{name} where there is nothing to be like: no contour of that height encloses anything.
/// About half a second for a lattice of 400 x 400 nodes.
void fill_outline(const Outline& outline, const FillTool& tool, ContourSet& set, const std::string& name, Seed seed,
                  const RunContext& run);

}  // namespace seamount::contour
