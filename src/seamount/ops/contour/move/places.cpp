#include "seamount/ops/contour/move/places.h"

#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/text.h"

namespace seamount::contour {

std::string place_text(Vec2 place) {
  const auto metres = [](double v) { return format_number(std::round(v * 1000.0) / 1000.0 + 0.0); };
  return "(" + metres(place.x) + ", " + metres(place.y) + ")";
}

void check_inside(const Polyline& places, const GridFrame& frame, const std::string& name) {
  for (size_t i = 0; i < places.size(); ++i) {
    const Vec2 p = places[i];
    if (p.x >= frame.west_m && p.x <= frame.east_m() && p.y >= frame.south_m() && p.y <= frame.north_m) continue;
    throw InvalidArgument(
        name, "point " + std::to_string(i) + " " + place_text(p) + " is outside the domain, which reaches from " +
                  place_text({frame.west_m, frame.south_m()}) + " to " + place_text({frame.east_m(), frame.north_m}));
  }
}

}  // namespace seamount::contour
