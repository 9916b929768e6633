#include "seamount/ops/contour/growth/rivers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/spline.h"

namespace seamount::contour {
namespace {

constexpr double kGrade = 0.03;     ///< mean fall of a river whose bed is not given, m/m
constexpr double kMinFall = 1e-4;   ///< m/m: what flat water falls all the same
constexpr double kJoinSteps = 2.0;  ///< a mouth this near to water comes to it,
constexpr double kJoinShare = 0.1;  ///< or this near, as a share of the river's length
constexpr double kHighest = 20000.0;

double length(Vec2 a) { return std::hypot(a.x, a.y); }

std::string name_of(size_t river) { return fmt::format("river {}", river); }

[[noreturn]] void fail(const std::string& field, size_t river, const std::string& problem) {
  throw InvalidArgument(field, name_of(river) + " " + problem);
}

void check_line(const RiverLine& line, size_t river, const std::string& field) {
  if (line.points.size() < 2)
    fail(field, river, fmt::format("has {} points; it needs at least two", line.points.size()));
  for (size_t i = 0; i < line.points.size(); ++i) {
    if (!std::isfinite(line.points[i].x) || !std::isfinite(line.points[i].y)) {
      fail(field, river, fmt::format("has no finite place at point {}", i));
    }
  }
  if (geom::line_length(line.points) == 0.0) fail(field, river, "has no length: all its points are one");
  const size_t beds = line.bed_m.size();
  if (beds > 2 && beds != line.points.size()) {
    fail(field, river,
         fmt::format("has {} beds for {} points; give one for each, one for source and mouth, one for the "
                     "mouth, or none",
                     beds, line.points.size()));
  }
  for (size_t i = 0; i < beds; ++i) {
    if (!(std::abs(line.bed_m[i]) <= kHighest)) {
      fail(field, river,
           fmt::format("has a bed at {} m, outside {}", format_number(line.bed_m[i]),
                       format_range(-kHighest, kHighest)));
    }
    if (i == 0 || line.bed_m[i] <= line.bed_m[i - 1]) continue;
    const Vec2 place = beds == line.points.size() ? line.points[i] : line.points.back();
    fail(field, river,
         fmt::format("rises from {} to {} m on its way to {}; its points run from source to mouth",
                     format_number(line.bed_m[i - 1]), format_number(line.bed_m[i]), geom::format_place(place)));
  }
  for (const double width : {line.source_width_m, line.mouth_width_m}) {
    if (!(width >= 0.0 && width <= 1e6)) fail(field, river, fmt::format("is {} m wide", format_number(width)));
  }
}

bool meets_regions(const Polyline& course, const RegionTree& tree) {
  return std::any_of(course.begin(), course.end(), [&](Vec2 p) { return region_at(tree, p) >= 0; });
}

/// Where a river ends: in another one or at the land's edge.
struct Mouth {
  int joins = -1;  ///< river
  Vec2 at;         ///< on it
};

double reach_of(const Polyline& course, double step_m) {
  return std::max(kJoinSteps * step_m, kJoinShare * geom::line_length(course));
}

std::vector<Mouth> find_mouths(const std::vector<Polyline>& courses, double step_m) {
  std::vector<Mouth> mouths(courses.size());
  for (size_t i = 0; i < courses.size(); ++i) {
    double nearest = reach_of(courses[i], step_m);
    for (size_t k = 0; k < courses.size(); ++k) {
      if (k == i) continue;
      const geom::Closest closest = geom::closest_on_polyline(courses[k], courses[i].back());
      // Two rivers with one mouth do not join each other: the first one is the one joined.
      const bool at_mouth = closest.along >= geom::line_length(courses[k]);
      if (closest.distance > nearest || (at_mouth && k > i)) continue;
      nearest = closest.distance;
      mouths[i] = {static_cast<int>(k), closest.point};
    }
  }
  return mouths;
}

/// A river that joins no other one ends in the sea, in a basin or beyond the domain's edge; one that all but does is
/// led there.
void lead_to_shore(const RegionTree& tree, const GridFrame& domain, double step_m, size_t river, Polyline& course,
                   const std::string& field) {
  const Vec2 end = course.back();
  const int region = region_at(tree, end);
  const bool beyond =
      end.x <= domain.west_m || end.x >= domain.east_m() || end.y <= domain.south_m() || end.y >= domain.north_m;
  if (region < 0 || tree.regions[static_cast<size_t>(region)].basin || beyond) return;
  const std::array<Vec2, 4> edges = {Vec2{domain.west_m, end.y}, Vec2{domain.east_m(), end.y},
                                     Vec2{end.x, domain.south_m()}, Vec2{end.x, domain.north_m}};
  Vec2 nearest = edges[0];
  const auto offer = [&](Vec2 p) {
    if (length(p - end) < length(nearest - end)) nearest = p;
  };
  for (const Vec2 edge : edges) offer(edge);
  for (const GrowthRegion& land : tree.regions) {
    if (land.parent >= 0) continue;
    Polyline outline = land.outline;
    outline.push_back(outline.front());
    offer(geom::closest_on_polyline(outline, end).point);
  }
  const double away = length(nearest - end);
  if (away > reach_of(course, step_m)) {
    fail(field, river,
         fmt::format("ends on land at {}, {} m from the nearest shore at {}; lead it to the sea, to another "
                     "river, into a basin or over the domain's edge",
                     geom::format_place(end), format_number(std::round(away)), geom::format_place(nearest)));
  }
  const Polyline rest =
      geom::sample_catmull_rom({end, nearest + (2.0 * step_m / std::max(away, step_m)) * (nearest - end)}, step_m);
  course.insert(course.end(), rest.begin() + 1, rest.end());
}

/// Joined rivers first.
std::vector<size_t> joining_order(const std::vector<Mouth>& mouths, const std::vector<Polyline>& courses,
                                  const std::string& field) {
  std::vector<size_t> order;
  std::vector<bool> placed(mouths.size(), false);
  while (order.size() < mouths.size()) {
    const size_t before = order.size();
    for (size_t i = 0; i < mouths.size(); ++i) {
      if (placed[i] || (mouths[i].joins >= 0 && !placed[static_cast<size_t>(mouths[i].joins)])) continue;
      placed[i] = true;
      order.push_back(i);
    }
    if (order.size() > before) continue;
    const auto stuck = static_cast<size_t>(std::find(placed.begin(), placed.end(), false) - placed.begin());
    fail(field, stuck,
         fmt::format("joins at {} a river that flows back into it", geom::format_place(courses[stuck].back())));
  }
  return order;
}

std::vector<double> ways(const Polyline& points) {
  std::vector<double> along(points.size(), 0.0);
  for (size_t i = 1; i < points.size(); ++i) along[i] = along[i - 1] + length(points[i] - points[i - 1]);
  return along;
}

double bed_at(const River& river, Vec2 place) {
  const geom::Closest closest = geom::closest_on_polyline(river.points, place);
  const std::vector<double> along = ways(river.points);
  size_t i = 1;
  while (i + 1 < along.size() && along[i] < closest.along) ++i;
  const double step = along[i] - along[i - 1];
  const double t = step > 0.0 ? std::clamp((closest.along - along[i - 1]) / step, 0.0, 1.0) : 0.0;
  return river.bed_m[i - 1] + t * (river.bed_m[i] - river.bed_m[i - 1]);
}

/// The height of the outermost outline around the river's end, or around the last of its points that is in a region.
double shore_height(const Polyline& course, const RegionTree& tree) {
  for (auto p = course.rbegin(); p != course.rend(); ++p) {
    int region = region_at(tree, *p);
    if (region < 0) continue;
    while (tree.regions[static_cast<size_t>(region)].parent >= 0)
      region = tree.regions[static_cast<size_t>(region)].parent;
    return tree.regions[static_cast<size_t>(region)].height_m.value_or(0.0);
  }
  return 0.0;
}

/// Beds at the drawn points, linear between them; at both ends, or one, or none: a graded profile.
std::vector<double> bed_profile(const RiverLine& line, const Polyline& course, double mouth_m) {
  const std::vector<double> along = ways(course);
  const double total = along.back();
  std::vector<double> bed(course.size());
  if (line.bed_m.size() == line.points.size() && line.bed_m.size() > 2) {
    size_t drawn = 0;  // drawn points are among those of the course, in order
    std::vector<double> at(line.points.size(), 0.0);
    for (size_t i = 0; i < course.size() && drawn < line.points.size(); ++i) {
      while (drawn < line.points.size() && course[i] == line.points[drawn]) at[drawn++] = along[i];
    }
    for (; drawn < line.points.size(); ++drawn) at[drawn] = total;
    size_t k = 1;
    for (size_t i = 0; i < course.size(); ++i) {
      while (k + 1 < at.size() && along[i] > at[k]) ++k;
      const double span = at[k] - at[k - 1];
      const double t = span > 0.0 ? std::clamp((along[i] - at[k - 1]) / span, 0.0, 1.0) : 1.0;
      bed[i] = line.bed_m[k - 1] + t * (line.bed_m[k] - line.bed_m[k - 1]);
    }
    return bed;
  }
  const double source = line.bed_m.size() == 2 ? line.bed_m.front() : mouth_m + kGrade * total;
  for (size_t i = 0; i < course.size(); ++i) {
    const double from_mouth = (total - along[i]) / total;
    bed[i] = mouth_m + (source - mouth_m) * from_mouth * from_mouth;
  }
  return bed;
}

/// Beds of reaches from their falls: a reach ends where one begins that it flows to, else at 0. Downstream reaches
/// stand after those that flow to them, as hydrology.rivers writes them, or in any order.
void add_falls(const std::vector<std::optional<double>>& falls, std::vector<RiverLine>& rivers) {
  std::map<std::pair<double, double>, size_t> begins;
  for (size_t i = 0; i < rivers.size(); ++i) {
    if (falls[i] && !rivers[i].points.empty()) begins[{rivers[i].points[0].x, rivers[i].points[0].y}] = i;
  }
  for (size_t i = 0; i < rivers.size(); ++i) {
    if (!falls[i] || rivers[i].points.empty() || !rivers[i].bed_m.empty()) continue;
    double mouth = 0.0;
    size_t reach = i;
    for (size_t passed = 0; passed < rivers.size(); ++passed) {  // never round a circle for ever
      const Vec2 end = rivers[reach].points.back();
      const auto next = begins.find({end.x, end.y});
      if (next == begins.end() || next->second == reach) break;
      reach = next->second;
      mouth += *falls[reach];
    }
    rivers[i].bed_m = {mouth + std::max(*falls[i], 0.0), mouth};
  }
}

}  // namespace

std::vector<River> prepare_rivers(const std::vector<RiverLine>& lines, const RegionTree& tree, const GridFrame& domain,
                                  double step_m, const std::string& field) {
  std::vector<Polyline> courses;
  for (size_t i = 0; i < lines.size(); ++i) {
    check_line(lines[i], i, field);
    courses.push_back(geom::sample_catmull_rom(lines[i].points, step_m));
    if (!meets_regions(courses[i], tree)) {
      fail(field, i,
           fmt::format("(from {} to {}) lies wholly outside the regions", geom::format_place(courses[i].front()),
                       geom::format_place(courses[i].back())));
    }
  }
  const std::vector<Mouth> mouths = find_mouths(courses, step_m);
  for (size_t i = 0; i < courses.size(); ++i) {
    if (mouths[i].joins < 0) lead_to_shore(tree, domain, step_m, i, courses[i], field);
  }
  std::vector<River> made(lines.size());
  std::vector<River> rivers;
  for (const size_t i : joining_order(mouths, courses, field)) {
    const RiverLine& line = lines[i];
    std::optional<double> joined;
    if (mouths[i].joins >= 0) {
      joined = bed_at(made[static_cast<size_t>(mouths[i].joins)], mouths[i].at);
      const Polyline rest = geom::sample_catmull_rom({courses[i].back(), mouths[i].at}, step_m);
      if (rest.size() > 1) courses[i].insert(courses[i].end(), rest.begin() + 1, rest.end());
    }
    if (joined && !line.bed_m.empty() && line.bed_m.back() < *joined) {
      fail(field, i,
           fmt::format("ends at {} m, below {} at {} m, which it joins at {}", format_number(line.bed_m.back()),
                       name_of(static_cast<size_t>(mouths[i].joins)),
                       format_number(std::round(100.0 * *joined) / 100.0), geom::format_place(mouths[i].at)));
    }
    const double shore = joined ? *joined : shore_height(courses[i], tree);
    River river{courses[i], bed_profile(line, courses[i], line.bed_m.empty() ? shore : line.bed_m.back()), {}};
    if (joined) river.bed_m.back() = *joined;
    const std::vector<double> along = ways(river.points);
    for (size_t k = river.points.size() - 1; k-- > 0;) {
      river.bed_m[k] = std::max(river.bed_m[k], river.bed_m[k + 1] + kMinFall * (along[k + 1] - along[k]));
    }
    for (const double way : along) {
      const double t = way / along.back();
      river.half_m.push_back(0.5 * (line.source_width_m + t * (line.mouth_width_m - line.source_width_m)));
    }
    made[i] = river;
    rivers.push_back(std::move(river));
  }
  return rivers;
}

std::vector<RiverLine> river_lines(const Drawing& drawing) {
  std::vector<RiverLine> rivers;
  std::vector<std::optional<double>> falls;
  for (const ValuedLine& line : drawing.lines) {
    const auto number = [&](const char* name) -> std::optional<double> {
      for (const Attribute& attribute : line.attributes) {
        if (attribute.name == name) return attribute.value;
      }
      return std::nullopt;
    };
    RiverLine river;
    river.points = line.points;
    const std::optional<double> source = number("source_m");
    const std::optional<double> mouth = number("mouth_m");
    if (source && mouth) river.bed_m = {*source, *mouth};
    if (!source && mouth) river.bed_m = {*mouth};
    const double width = number("width_m").value_or(0.0);
    river.source_width_m = number("source_width_m").value_or(width);
    river.mouth_width_m = number("mouth_width_m").value_or(width);
    falls.push_back(number("fall_m"));
    rivers.push_back(std::move(river));
  }
  add_falls(falls, rivers);
  return rivers;
}

}  // namespace seamount::contour
