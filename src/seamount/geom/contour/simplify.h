// Fewer points for contours, and still no two that meet.
#pragma once

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"

namespace seamount::geom {

/// Douglas-Peucker on all rings at once: no dropped point lies further than tolerance_m from its ring. Edges that would
/// meet others or pass over a whole contour are given points back until none do. Heights, order and the tree of
/// inclusion stay, rings keep at least three points. REQUIRES: find_contour_crossing() finds nothing; tolerance_m > 0.
/// About n log n.
void simplify_contours(std::vector<Contour>& contours, double tolerance_m, const RunContext& run);

}  // namespace seamount::geom
