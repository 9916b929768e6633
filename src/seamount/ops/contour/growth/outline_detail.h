// The detail that outlines drawn with a few points lack.
//
// P2 draws regions as coarse polygons and gets their detail from the unevenness of the nodes alone, so that a coast
// drawn with a dozen points keeps a dozen straight sides however many nodes there are. Here corners are rounded by a
// spline, then one common field of displacement (roughen.h) is laid over all outlines and rivers: one to one, so that
// nesting stays. Its longest waves are as long as two and a half of their sides: what was drawn is kept, what lies
// below its resolution is added.
#pragma once

#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/contour/growth/regions.h"
#include "seamount/ops/contour/growth/rivers.h"

namespace seamount::contour {

/// Displaces outlines, down to the domain's cell size, and the points of rivers along with them. `irregularity` in
/// (0, 1]: the displacement's deviation in fifths of a side. The displacement fades out towards the domain's edge;
/// outlines that reach it keep their corners. Throws InvalidArgument{"outlines"} where splines through neighbouring
/// outlines cross. Parallel; about 3 us a cell of outline.
void add_outline_detail(RegionTree& tree, std::vector<RiverLine>& rivers, double irregularity, const GridFrame& domain,
                        Seed seed, const RunContext& run);

}  // namespace seamount::contour
