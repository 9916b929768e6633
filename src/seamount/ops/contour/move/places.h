// How tools of contour.edit speak of places, and which places they accept.
#pragma once

#include <string>

#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::contour {

/// "(1200.5, -300)", to the millimetre.
std::string place_text(Vec2 place);

/// Throws InvalidArgument{name} for the first place that is not finite or lies outside the frame; the message names
/// the place and the frame.
void check_inside(const Polyline& places, const GridFrame& frame, const std::string& name);

}  // namespace seamount::contour
