// Iso-contours of a triangulated network by marching triangles (P2 sec. 4.4), all levels in one pass.
//
// A node is high where its height >= the level; contours cross edges by linear interpolation. Where a level equals a
// node's height, contours pass it at a ten thousandth of the edge, so that they never touch there. Departures: one pass
// over the triangles instead of one per level; land at the network's border is closed by a narrow apron of triangles
// that falls below every level, as the paper's nodes outside the domain do.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/tin.h"

namespace seamount::geom {

/// The contours at all of the levels, closed, higher ground on the left, that neither cross nor touch each other or
/// themselves. Lower ones reach further out beyond the network's border, at most a quarter of its edges there. Not
/// nested yet (nesting.h). In the order of the triangles that they pass first, the same on any number of threads.
///
/// REQUIRES: levels ascend strictly; find_tin_defect() finds nothing; heights for all nodes. Throws InvalidArgument
/// where triangles turn out not to fit together. Linear in triangles and points.
std::vector<Contour> march_triangles(const Tin& tin, std::span<const double> levels, const RunContext& run);

/// What is wrong with a network, in one line for its author: places or heights that are not finite, lists of other
/// lengths than there are nodes, triangles that name nodes that are not there or do not run counter-clockwise, more
/// than two triangles at an edge, triangles that overlap, regions out of order. Nothing if it is sound. About n log n.
std::optional<std::string> find_tin_defect(const Tin& tin);

}  // namespace seamount::geom
