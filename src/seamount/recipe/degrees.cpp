#include "seamount/recipe/degrees.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/projection.h"

namespace seamount::recipe {
namespace {

std::string rounded(double degrees) { return format_number(std::round(degrees * 1e4) / 1e4 + 0.0); }

}  // namespace

std::string degrees_text(Vec2 degrees) {
  return "longitude " + rounded(degrees.x) + ", latitude " + rounded(degrees.y);
}

std::string degrees_text(const GridFrame& frame) {
  const std::vector<Vec2> corners = io::to_lonlat({{frame.west_m, frame.north_m},
                                                   {frame.east_m(), frame.north_m},
                                                   {frame.west_m, frame.south_m()},
                                                   {frame.east_m(), frame.south_m()}},
                                                  frame.crs);
  Vec2 low = corners.front(), high = corners.front();
  for (const Vec2 corner : corners) {
    low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
    high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
  }
  return "longitude " + rounded(low.x) + " to " + rounded(high.x) + ", latitude " + rounded(low.y) + " to " +
         rounded(high.y);
}

std::optional<Vec2> place_in_metres(const Degrees& degrees, bool metres_too, const GridFrame& frame,
                                    const std::string& prefix, const std::string& metres) {
  if (degrees.longitude.has_value() != degrees.latitude.has_value())
    throw InvalidArgument(prefix + (degrees.longitude ? "latitude_deg" : "longitude_deg"),
                          "is missing: a place has both");
  if (!degrees.longitude) return std::nullopt;
  const std::string name = prefix + "longitude_deg";
  if (metres_too) throw InvalidArgument(name, "contradicts " + metres + ": give one place");
  if (frame.crs.empty()) throw InvalidArgument(name, "the terrain has no coordinate system; give " + metres);
  const Vec2 place{*degrees.longitude, *degrees.latitude};
  try {
    return io::from_lonlat({place}, frame.crs).front();
  } catch (const InvalidArgument&) {
    throw InvalidArgument(name, degrees_text(place) + " is outside of what the terrain's coordinate system holds for");
  }
}

}  // namespace seamount::recipe
