#include "seamount/ops/contour/edit/pattern.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/polygon/predicates.h"
#include "seamount/ops/contour/edit/edit_area.h"
#include "seamount/ops/contour/edit/selection.h"

namespace seamount::contour {
namespace {

constexpr double kContext = 0.06;  ///< of the outline's extent

Vec2 middle_of(const Polygon& polygon) {
  const geom::Box box = geom::bounding_box(polygon.outer);
  return 0.5 * (box.low + box.high);
}

void shift(Polyline& points, Vec2 by) {
  for (Vec2& p : points) p = p + by;
}

/// A place where a contour crosses the outline's outer ring.
struct OutlineCrossing {
  double along;  ///< arc length of the ring
  double height_m;
};

/// Cuts contours at the outline.
class Clipper {
 public:
  explicit Clipper(const Polygon& outline) : outline_(outline), box_(geom::bounding_box(outline.outer)) {
    add_edges(outline.outer, true);
    for (const Ring& hole : outline.holes) add_edges(hole, false);
  }

  void clip(const Contour& contour) {
    const geom::Box own = geom::bounding_box(contour.ring);
    if (own.low.x > box_.high.x || own.high.x < box_.low.x || own.low.y > box_.high.y || own.high.y < box_.low.y)
      return;
    const size_t n = contour.ring.size();
    const size_t first_line = lines_.size();
    const bool began_inside = geom::contains(outline_, contour.ring[0]);
    bool inside = began_inside;
    Polyline line;
    for (size_t i = 0; i < n; ++i) {
      const Vec2 a = contour.ring[i];
      const Vec2 b = contour.ring[(i + 1) % n];
      if (inside) line.push_back(a);
      for (const double t : crossings(a, b, contour.height_m)) {
        line.push_back(a + t * (b - a));
        if (inside) finish(line, contour.height_m, false);
        inside = !inside;
      }
    }
    if (!inside) return;
    if (lines_.size() == first_line) return finish(line, contour.height_m, true);
    Polyline& first = lines_[first_line].points;  // it began at the ring's first point: the two are one
    line.insert(line.end(), first.begin(), first.end());
    first = std::move(line);
  }

  std::vector<ValuedLine>& lines() { return lines_; }

  /// Mean height along the outer ring, linear between crossings; `otherwise` without any.
  double mean_height(double otherwise) {
    if (met_.empty()) return otherwise;
    std::sort(met_.begin(), met_.end(),
              [](const OutlineCrossing& a, const OutlineCrossing& b) { return a.along < b.along; });
    double sum = 0.0;
    for (size_t i = 0; i < met_.size(); ++i) {
      const bool last = i + 1 == met_.size();
      const OutlineCrossing& next = met_[last ? 0 : i + 1];
      const double length = next.along - met_[i].along + (last ? length_ : 0.0);
      sum += 0.5 * length * (met_[i].height_m + next.height_m);
    }
    return sum / length_;
  }

 private:
  struct OutlineEdge {
    Vec2 a, b, d;
    double along;
    bool outer;
  };

  void add_edges(const Ring& ring, bool outer) {
    double along = 0.0;
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vec2 b = ring[(i + 1) % ring.size()];
      const Vec2 d = b - ring[i];
      edges_.push_back({ring[i], b, d, along, outer});
      along += std::hypot(d.x, d.y);
    }
    if (outer) length_ = along;
  }

  /// Where a + t (b - a) crosses the outline, ascending. Ends count by which side they are on, so a touch is never one
  /// crossing.
  const std::vector<double>& crossings(Vec2 a, Vec2 b, double height) {
    at_.clear();
    const Vec2 d = b - a;
    if (std::min(a.x, b.x) > box_.high.x || std::max(a.x, b.x) < box_.low.x || std::min(a.y, b.y) > box_.high.y ||
        std::max(a.y, b.y) < box_.low.y)
      return at_;
    for (const OutlineEdge& edge : edges_) {
      const bool a_left = geom::orientation_sign(edge.a, edge.b, a) > 0;
      const bool b_left = geom::orientation_sign(edge.a, edge.b, b) > 0;
      const bool from_left = geom::orientation_sign(a, b, edge.a) > 0;
      const bool to_left = geom::orientation_sign(a, b, edge.b) > 0;
      if (a_left == b_left || from_left == to_left) continue;
      const double t = cross(edge.a - a, edge.d) / cross(d, edge.d);
      at_.push_back(std::clamp(t, 0.0, 1.0));
      if (!edge.outer) continue;
      const Vec2 off = a + at_.back() * d - edge.a;
      met_.push_back({edge.along + std::hypot(off.x, off.y), height});
    }
    std::sort(at_.begin(), at_.end());
    return at_;
  }

  void finish(Polyline& line, double height, bool closed) {
    Polyline kept;
    for (const Vec2 p : line) {
      if (kept.empty() || !(kept.back() == p)) kept.push_back(p);
    }
    line.clear();
    if (kept.size() >= (closed ? 3U : 2U)) lines_.push_back({std::move(kept), height, closed});
  }

  const Polygon& outline_;
  geom::Box box_;
  std::vector<OutlineEdge> edges_;
  double length_ = 0.0;
  std::vector<double> at_;
  std::vector<ValuedLine> lines_;
  std::vector<OutlineCrossing> met_;
};

double mean_height(const ContourSet& set, const Polygon& outline) {
  Clipper clipper(outline);
  for (const Contour& contour : set.contours) clipper.clip(contour);
  return clipper.mean_height(set.contours.empty() ? 0.0 : height_around(set, outline.outer[0]));
}

/// A box around the outline with some ground to spare.
Polygon context(const Polygon& outline) {
  const geom::Box box = geom::bounding_box(outline.outer);
  const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const Vec2 spare = {kContext * extent, kContext * extent};
  const Vec2 low = box.low - spare;
  const Vec2 high = box.high + spare;
  return {{low, {high.x, low.y}, high, {low.x, high.y}}, {}};
}

}  // namespace

Outline find_outline(const ContourSet& set, const std::vector<Polygon>& within, const Selection& selection,
                     const std::string& name) {
  const bool selects = describe(selection) != "all";
  if (within.empty() == !selects)
    throw InvalidArgument(name, within.empty() ? "needs \"within\" (an outline) or \"select\" (a contour)"
                                               : "has \"within\" and \"select\"; one of them says the outline");
  if (within.size() > 1)
    throw InvalidArgument(name + ".within", "has " + std::to_string(within.size()) + " polygons; an outline is one");
  if (!within.empty()) {
    if (const auto defect = geom::find_defect(within[0])) throw InvalidArgument(name + ".within", *defect);
    return {within[0], -1};
  }
  const std::vector<size_t> chosen = select(set, selection, name + ".select");
  if (chosen.size() != 1)
    throw InvalidArgument(name + ".select", "finds " + std::to_string(chosen.size()) +
                                                " contours; an outline is one contour (" + describe(selection) + ")");
  return {{set.contours[chosen[0]].ring, {}}, static_cast<int>(chosen[0])};
}

Drawing make_pattern(const ContourSet& set, const Outline& outline) {
  Drawing pattern;
  double base = 0.0;
  if (outline.contour >= 0) {
    std::vector<char> inside(set.contours.size(), 0);
    inside[static_cast<size_t>(outline.contour)] = 1;
    for (size_t i = static_cast<size_t>(outline.contour); i < set.contours.size(); ++i) {
      const Contour& contour = set.contours[i];
      if (contour.parent >= 0 && inside[static_cast<size_t>(contour.parent)] != 0) inside[i] = 1;
      if (inside[i] != 0) pattern.lines.push_back({contour.ring, contour.height_m, true});
    }
    base = set.contours[static_cast<size_t>(outline.contour)].height_m;
  } else {
    base = mean_height(set, outline.polygon);
    const Polygon around = context(outline.polygon);
    Clipper clipper(around);
    for (const Contour& contour : set.contours) clipper.clip(contour);
    pattern.lines = std::move(clipper.lines());
  }
  const Vec2 middle = middle_of(outline.polygon);
  const Vec2 back = {-middle.x, -middle.y};
  NamedArea area{"outline", {outline.polygon}};
  shift(area.parts[0].outer, back);
  for (Ring& hole : area.parts[0].holes) shift(hole, back);
  for (ValuedLine& line : pattern.lines) {
    shift(line.points, back);
    line.value -= base;
  }
  pattern.areas.push_back(std::move(area));
  return pattern;
}

Drawing pattern(const ContourSet& set, const PatternParams& params, const RunContext& run) {
  check_params(params);
  run.check_cancelled();
  std::vector<Polygon> within = params.within;
  if (within.empty() && describe(params.select) == "all") {
    const GridFrame& frame = set.frame;
    within.push_back({{{frame.west_m, frame.south_m()},
                       {frame.east_m(), frame.south_m()},
                       {frame.east_m(), frame.north_m},
                       {frame.west_m, frame.north_m}},
                      {}});
  }
  const Outline outline = find_outline(set, within, params.select, "params");
  Drawing made = make_pattern(set, outline);
  if (made.lines.empty()) throw InvalidArgument("within", "no contour comes into the outline");
  return made;
}

void check_pattern(const Drawing& pattern, const std::string& name) {
  if (pattern.areas.empty() || pattern.areas[0].parts.size() != 1)
    throw InvalidArgument(name, "is no pattern: it needs one area, its outline, besides its lines");
  if (const auto defect = geom::find_defect(pattern.areas[0].parts[0]))
    throw InvalidArgument(name, "its outline is not sound: " + *defect);
  if (pattern.lines.empty()) throw InvalidArgument(name, "is no pattern: it has no lines within its outline");
}

}  // namespace seamount::contour
