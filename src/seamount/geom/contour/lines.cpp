#include "seamount/geom/contour/lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/frame_around.h"

namespace seamount::geom {
namespace {

std::string place(Vec2 p) { return fmt::format("({:.0f}, {:.0f})", p.x, p.y); }

/// "line 3 (120 m)".
std::string quoted(const Contour& contour, size_t i) {
  return fmt::format("line {} ({} m)", i, format_number(contour.height_m));
}

void check_line(const ValuedLine& line, size_t i, const std::string& field) {
  const std::string name = fmt::format("line {} ({} m)", i, format_number(line.value));
  if (line.points.empty()) throw InvalidArgument(field, name + " has no points");
  if (!line.closed) {
    throw InvalidArgument(field, fmt::format("{} is open: it runs from {} to {}; contours are closed", name,
                                             place(line.points.front()), place(line.points.back())));
  }
  if (line.points.size() < 3)
    throw InvalidArgument(field, name + " has fewer than three points, at " + place(line.points.front()));
  if (!std::isfinite(line.value)) throw InvalidArgument(field, name + " has no height");
}

}  // namespace

Drawing to_lines(const ContourSet& set) {
  Drawing drawing;
  drawing.crs = set.frame.crs;
  drawing.heights = true;
  drawing.frame = set.frame;
  drawing.lines.reserve(set.contours.size());
  for (const Contour& contour : set.contours) drawing.lines.push_back({contour.ring, contour.height_m, true, {}});
  return drawing;
}

ContourSet contours_from_lines(const Drawing& drawing, const GridFrame& frame, const std::string& field) {
  if (drawing.lines.empty()) throw InvalidArgument(field, "holds no lines");
  ContourSet set;
  set.contours.reserve(drawing.lines.size());
  for (size_t i = 0; i < drawing.lines.size(); ++i) {
    const ValuedLine& line = drawing.lines[i];
    check_line(line, i, field);
    Contour contour{line.value, line.points, -1};
    const auto repeated = std::unique(contour.ring.begin(), contour.ring.end());
    contour.ring.erase(repeated, contour.ring.end());
    if (contour.ring.size() < 3)
      throw InvalidArgument(field, quoted(contour, i) + " has fewer than three places, at " + place(line.points[0]));
    set.contours.push_back(std::move(contour));
  }
  if (const auto crossing = find_contour_crossing(set.contours)) {
    const std::string first = quoted(set.contours[crossing->first], crossing->first);
    const std::string second =
        crossing->first == crossing->second ? "itself" : quoted(set.contours[crossing->second], crossing->second);
    throw InvalidArgument(field, first + " meets " + second + " at " + place(crossing->at) + "; contours never touch");
  }
  std::vector<Vec2> places;
  for (const Contour& contour : set.contours) places.insert(places.end(), contour.ring.begin(), contour.ring.end());
  set.frame = frame_around(places, drawing.frame.value_or(frame));
  set.frame.crs = drawing.crs.empty() ? frame.crs : drawing.crs;
  nest_contours(set.contours);
  orient_contours(set.contours);
  return set;
}

}  // namespace seamount::geom
