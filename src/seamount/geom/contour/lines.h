// Contours as a drawing of closed lines, and back: how they go to files and come from them.
#pragma once

#include <string>

#include "seamount/model/areas.h"
#include "seamount/model/contour_set.h"

namespace seamount::geom {

/// Closed lines whose values are the contours' heights, with their frame. Linear.
Drawing to_lines(const ContourSet& set);

/// The closed lines of a drawing as nested contours, turned so that higher ground is on their left. The frame is the
/// drawing's own, or `frame` if it has none, where they lie in it (or stick out by a tenth), else one of as many cells
/// around them. Throws InvalidArgument{field} naming the line and a place: no lines, an open one, one of fewer than
/// three points or without a finite height, lines that cross or touch. n log n.
ContourSet contours_from_lines(const Drawing& drawing, const GridFrame& frame, const std::string& field);

}  // namespace seamount::geom
