// Contours as a drawing of closed lines, and back: how they go to files and come from them.
#pragma once

#include <string>

#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/contour_set.h"

namespace seamount::geom {

/// Closed lines whose values are the contours' heights, with their frame. Linear.
Drawing to_lines(const ContourSet& set);

/// The same as they are within their frame: open where they leave it, so that none runs along its border. Lines run
/// with higher ground on their left. Linear.
Drawing to_cut_lines(const ContourSet& set);

/// The lines of a drawing as nested contours, turned so that higher ground is on their left. The frame is the drawing's
/// own, or `frame` if it has none, where they lie in it (or stick out by a tenth), else one of as many cells around
/// them.
///
/// Open lines are closed along the border that they end at (close_lines.h): the drawing's frame, `sheet` if it is not
/// empty (the rectangle around the lines as their file has it), the rectangle around them, or their hull. The frame is
/// then the largest in it.
/// Throws InvalidArgument{field} naming the line and a place: no lines, one of fewer than three points or without a
/// finite height, lines that cross or touch, what close_lines() throws. n log n.
ContourSet contours_from_lines(const Drawing& drawing, const GridFrame& frame, const std::string& field,
                               const Ring& sheet = {}, const RunContext& run = {});

}  // namespace seamount::geom
