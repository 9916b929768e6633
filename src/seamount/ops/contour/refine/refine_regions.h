// A network fitted to held contours that are finer than it can show.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/tin.h"

namespace seamount::contour {

/// Moves nodes to other regions until water finds its way out of each: river nodes to the region of their bed's height,
/// parts of a hill's region that the network cuts off from all lower ground to the region around them. Then takes out
/// regions without nodes; what they enclosed belongs to what encloses them. Throws InvalidArgument where nothing is
/// left. REQUIRES: every region has a height. About linear.
void fit_regions(Tin& tin, const RunContext& run);

}  // namespace seamount::contour
