#include "seamount/geom/polygon/frame_around.h"

#include <algorithm>
#include <cmath>

#include "seamount/geom/polygon/polygon.h"

namespace seamount::geom {

GridFrame frame_around(const std::vector<Vec2>& places, const GridFrame& wanted) {
  const Box box = bounding_box(places);
  const double x = 0.1 * wanted.width_m(), y = 0.1 * wanted.height_m();
  const bool inside = box.low.x >= wanted.west_m - x && box.high.x <= wanted.east_m() + x &&
                      box.low.y >= wanted.south_m() - y && box.high.y <= wanted.north_m + y;
  if (inside) return wanted;
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  GridFrame frame = wanted;
  frame.cell_m = std::max({width, height, 1e-3}) / std::max(wanted.width, wanted.height);
  frame.width = std::max(1, static_cast<int>(std::lround(width / frame.cell_m)));
  frame.height = std::max(1, static_cast<int>(std::lround(height / frame.cell_m)));
  frame.west_m = 0.5 * (box.low.x + box.high.x - frame.width_m());
  frame.north_m = 0.5 * (box.low.y + box.high.y + frame.height_m());
  return frame;
}

}  // namespace seamount::geom
