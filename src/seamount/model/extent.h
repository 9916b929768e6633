// Where something lies: the upright rectangle around it, in a coordinate system.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "seamount/base/text.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount {

struct Extent {
  std::string crs = {};  ///< as GridFrame's; empty: local metres
  double west = 0.0, south = 0.0, east = 0.0, north = 0.0;

  static Extent of(const GridFrame& frame) {
    return {frame.crs, frame.west_m, frame.south_m(), frame.east_m(), frame.north_m};
  }

  Vec2 middle() const { return {0.5 * (west + east), 0.5 * (south + north)}; }
  bool contains(Vec2 place) const { return place.x >= west && place.x <= east && place.y >= south && place.y <= north; }
  /// REQUIRES: the same system.
  bool overlaps(const Extent& other) const {
    return west <= other.east && east >= other.west && south <= other.north && north >= other.south;
  }
  void include(const Extent& other) {
    west = std::min(west, other.west);
    south = std::min(south, other.south);
    east = std::max(east, other.east);
    north = std::max(north, other.north);
  }
};

/// "x 500000 m, y 3100000 m", to the metre; near the origin to the centimetre.
inline std::string metres_text(Vec2 place) {
  const auto metres = [](double value) {
    const double unit = std::abs(value) < 1000 ? 100 : 1;
    return format_number(std::round(value * unit) / unit + 0.0);
  };
  return "x " + metres(place.x) + " m, y " + metres(place.y) + " m";
}

/// "x 500000 to 510240 m, y 3100000 to 3110240 m in EPSG:32627", to the metre.
inline std::string extent_text(const Extent& extent) {
  constexpr size_t kLongest = 40;
  const auto metres = [](double value) { return format_number(std::round(value)); };
  std::string where = extent.crs.empty() ? "local metres" : extent.crs;
  if (where.size() > kLongest) where = where.substr(0, kLongest - 3) + "...";
  return "x " + metres(extent.west) + " to " + metres(extent.east) + " m, y " + metres(extent.south) + " to " +
         metres(extent.north) + " m in " + where;
}

}  // namespace seamount
