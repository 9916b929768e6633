// Places that parameters give in longitude and latitude, for operators, which know metres alone.
#pragma once

#include <optional>
#include <string>

#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::recipe {

/// A place on WGS 84, as parameters hold it.
struct Degrees {
  std::optional<double> longitude, latitude;
};

/// The place in metres of the frame's system; nothing if no degrees are given. `prefix` stands before the fields'
/// names, `metres` says how a place is given in metres. Throws InvalidArgument{prefix + "longitude_deg" or
/// "latitude_deg"}: one without the other, metres given too, no coordinate system, a place outside of it.
std::optional<Vec2> place_in_metres(const Degrees& degrees, bool metres_too, const GridFrame& frame,
                                    const std::string& prefix, const std::string& metres);

/// "longitude 8.12, latitude 46.43", to about ten metres.
std::string degrees_text(Vec2 degrees);

/// "longitude 8.01 to 8.2, latitude 46.3 to 46.5": around a frame that has a system.
std::string degrees_text(const GridFrame& frame);

}  // namespace seamount::recipe
