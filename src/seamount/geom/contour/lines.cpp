#include "seamount/geom/contour/lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/contour/close_lines.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/contour/sheet.h"
#include "seamount/geom/polygon/frame_around.h"
#include "seamount/geom/polygon/frame_clipping.h"

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
  if (!std::isfinite(line.value)) throw InvalidArgument(field, name + " has no height");
  const size_t least = line.closed ? 3 : 2;
  if (line.points.size() < least)
    throw InvalidArgument(field, fmt::format("{} has fewer than {} points, at {}", name, least == 3 ? "three" : "two",
                                             place(line.points.front())));
}

/// The closed lines as they are.
std::vector<Contour> rings_of(const std::vector<ValuedLine>& lines, const std::string& field) {
  std::vector<Contour> contours;
  contours.reserve(lines.size());
  for (size_t i = 0; i < lines.size(); ++i) {
    Contour contour{lines[i].value, lines[i].points, -1};
    const auto repeated = std::unique(contour.ring.begin(), contour.ring.end());
    contour.ring.erase(repeated, contour.ring.end());
    if (contour.ring.size() < 3)
      throw InvalidArgument(field,
                            quoted(contour, i) + " has fewer than three places, at " + place(lines[i].points[0]));
    contours.push_back(std::move(contour));
  }
  return contours;
}

std::vector<Contour> close_at_border(const Drawing& drawing, const GridFrame& wanted, const std::string& field,
                                     const Ring& given, GridFrame& frame, const RunContext& run) {
  constexpr double kTolerance = 2e-3;
  std::vector<Ring> candidates;
  if (drawing.frame) candidates.push_back(frame_ring(*drawing.frame));
  if (given.size() >= 3) candidates.push_back(given);
  candidates.push_back(rectangle_around(drawing.lines));
  if (Ring hull = hull_around(drawing.lines); hull.size() >= 3) candidates.push_back(std::move(hull));
  const SheetBorder sheet = choose_sheet(candidates, drawing.lines, kTolerance);
  frame = drawing.frame ? *drawing.frame : frame_in(sheet, wanted);
  return close_lines(drawing.lines, sheet, {field, frame.cell_m, frame, drawing.frame.has_value()}, run);
}

void check_crossings(const std::vector<Contour>& contours, const std::string& field) {
  const auto crossing = find_contour_crossing(contours);
  if (!crossing) return;
  const std::string first = quoted(contours[crossing->first], crossing->first);
  const std::string second =
      crossing->first == crossing->second ? "itself" : quoted(contours[crossing->second], crossing->second);
  throw InvalidArgument(field, first + " meets " + second + " at " + place(crossing->at) + "; contours never touch");
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

Drawing to_cut_lines(const ContourSet& set) {
  Drawing drawing = to_lines(set);
  drawing.lines.clear();
  for (const Contour& contour : set.contours)
    for (FrameRun& run : runs_in_frame(contour.ring, set.frame))
      drawing.lines.push_back({std::move(run.points), contour.height_m, run.closed, {}});
  return drawing;
}

ContourSet contours_from_lines(const Drawing& drawing, const GridFrame& frame, const std::string& field,
                               const Ring& sheet, const RunContext& run) {
  if (drawing.lines.empty()) throw InvalidArgument(field, "holds no lines");
  for (size_t i = 0; i < drawing.lines.size(); ++i) check_line(drawing.lines[i], i, field);
  const bool open =
      std::any_of(drawing.lines.begin(), drawing.lines.end(), [](const ValuedLine& line) { return !line.closed; });
  ContourSet set;
  if (open) {
    set.contours = close_at_border(drawing, frame, field, sheet, set.frame, run);
  } else {
    set.contours = rings_of(drawing.lines, field);
    std::vector<Vec2> places;
    for (const Contour& contour : set.contours) places.insert(places.end(), contour.ring.begin(), contour.ring.end());
    set.frame = frame_around(places, drawing.frame.value_or(frame));
  }
  set.frame.crs = drawing.crs.empty() ? frame.crs : drawing.crs;
  check_crossings(set.contours, field);
  nest_contours(set.contours, run);
  orient_contours(set.contours);
  return set;
}

}  // namespace seamount::geom
