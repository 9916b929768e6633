// Filling an outline with new ground that is like its surroundings (P2 sec. 6.6).
//
// Inside a contour the ground grows inward from it as in P2 sec. 4.2, here as a front whose speed is noise (what Open
// Eden Growth becomes on ever finer networks): fast places become valleys, and each place is reached after a neighbour
// of its, so no basin comes about. Its heights are the quantiles of what other contours of that height enclose, the
// nearest first; where there are none, of what was there before.
//
// A polygon that crosses contours is filled with the piece of ground that fits it best, of a library of patterns or of
// the set itself (match.h), fitted to the heights along the outline and blended in over a wide rim (lay_ground.h), so
// that contours go on across it as slopes do; valleys are cut for water that it would dam (outflow.h).
#pragma once

#include <string>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"
#include "seamount/ops/contour/edit/fill_polygon.h"
#include "seamount/ops/contour/edit/pattern.h"
#include "seamount/ops/contour/edit/tools.h"

namespace seamount::contour {

/// Throws InvalidArgument{name} where there is nothing to be like: no contour of that height encloses anything.
/// `library` serves polygons alone. About half a second for a lattice of 400 x 400 nodes.
void fill_outline(const Outline& outline, const FillTool& tool, const std::vector<LibraryPattern>& library,
                  ContourSet& set, const std::string& name, Seed seed, const RunContext& run);

}  // namespace seamount::contour
