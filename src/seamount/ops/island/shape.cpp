#include "seamount/ops/island/shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/contour/contour.h"
#include "seamount/geom/polygon/joined_lines.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/scalar/spline.h"

namespace seamount::island {
namespace {

constexpr int kPolarSamples = 720;
constexpr double kPi = std::numbers::pi;

RegionWidths complete_widths(double land_m2, const GivenWidths& given) {
  const RegionWidths natural = natural_widths(land_m2);
  return {given.beach_m.value_or(natural.beach_m), given.lagoon_m.value_or(natural.lagoon_m),
          given.reef_m.value_or(natural.reef_m), given.slope_m.value_or(natural.slope_m)};
}

double polar_area(const std::vector<double>& radii) {
  double sum = 0;
  for (const double r : radii) sum += r * r;
  return kPi * sum / static_cast<double>(radii.size());
}

double areas_m2(const std::vector<Polygon>& polygons) {
  double sum = 0;
  for (const Polygon& polygon : polygons) sum += geom::area(polygon);
  return sum;
}

void check_order(const std::vector<PolarOutline>& outlines) {
  for (size_t i = 0; i + 1 < outlines.size(); ++i) {
    for (size_t a = 0; a < outlines[i].radii_m.size(); ++a) {
      if (outlines[i].radii_m[a] < outlines[i + 1].radii_m[a]) continue;
      throw InvalidArgument(
          "outlines", fmt::format("outline {} ({:.6g} m) does not lie inside outline {} ({:.6g} m) at {:.1f} degrees",
                                  i + 1, outlines[i].radii_m[a], i + 2, outlines[i + 1].radii_m[a],
                                  360.0 * static_cast<double>(a) / kPolarSamples));
    }
  }
}

/// How far outlines may leave those around them: traced from labels and simplified they overlap by up to two cells and
/// a half, where an edge is about a cell long, and x~ puts them in order. In drawn ones no more than a small part of
/// the land.
double accuracy_of(const Plan& plan, int inner) {
  constexpr double kEdges = 2.5, kShare = 0.04;
  double length = 0.0, largest = 0.0;
  size_t points = 0;
  for (const Polygon& polygon : plan.areas[static_cast<size_t>(inner)]) {
    length += geom::ring_length(polygon.outer);
    points += polygon.outer.size();
    largest = std::max(largest, std::abs(geom::signed_area(polygon.outer)));
  }
  return std::min(kEdges * length / static_cast<double>(std::max<size_t>(points, 1)), kShare * std::sqrt(largest));
}

/// Does ring `inner` leave `outer` by more than that?
bool leaves(const Ring& inner, const Ring& outer, double accuracy) {
  Polyline border = outer;
  border.push_back(outer.front());
  for (const Vec2 p : geom::densify(inner, std::max(accuracy, geom::ring_length(inner) / 4000))) {
    if (!geom::contains(outer, p) && geom::closest_on_polyline(border, p).distance > accuracy) return true;
  }
  return false;
}

/// Does a part lie beside an outline that it cannot cross, being smaller than the accuracy itself?
bool lies_beside(const Ring& inner, const Ring& outer, double accuracy) {
  Polyline border = outer;
  border.push_back(outer.front());
  return geom::closest_on_polyline(border, inner.front()).distance <= accuracy;
}

/// Nested outlines must not cross.
void check_nesting(const Plan& plan, const std::string& name) {
  for (int i = 0; i < kOutlineCount; ++i) {
    const double accuracy = accuracy_of(plan, i);
    for (int j = i + 1; j < kOutlineCount; ++j) {
      for (const Polygon& inner : plan.areas[i]) {
        bool inside = plan.areas[j].empty();
        for (const Polygon& outer : plan.areas[j]) {
          const auto place = geom::find_crossing(inner.outer, outer.outer);
          inside = inside || place || geom::contains(outer.outer, inner.outer.front()) ||
                   lies_beside(inner.outer, outer.outer, accuracy);
          if (!place || !leaves(inner.outer, outer.outer, accuracy)) continue;
          throw InvalidArgument(name, fmt::format("outline '{}' crosses outline '{}' at x = {:.1f} m, y = {:.1f} m",
                                                  kAreaNames[i], kAreaNames[j], place->x, place->y));
        }
        if (!inside) {
          throw InvalidArgument(name,
                                fmt::format("outline '{}' lies outside outline '{}'", kAreaNames[i], kAreaNames[j]));
        }
      }
    }
  }
}

void measure(Plan& plan, const GivenWidths& widths) {
  plan.land_m2 = areas_m2(land_of(plan));
  plan.widths = complete_widths(plan.land_m2, widths);
  plan.lobes = find_lobes(land_of(plan));
}

}  // namespace

const std::vector<Polygon>& land_of(const Plan& plan) {
  if (!plan.areas[kCoast].empty()) return plan.areas[kCoast];
  for (const auto& area : plan.areas) {
    if (!area.empty()) return area;
  }
  return plan.areas[kCoast];
}

Plan as_areas(const Plan& plan) {
  if (plan.polar.empty()) return plan;
  Plan out = plan;
  out.polar.clear();
  for (size_t i = 0; i < plan.polar.size(); ++i) {
    if (plan.derived && i != kCoast) continue;
    const std::vector<double>& radii = plan.polar[i].radii_m;
    Ring ring;
    for (size_t a = 0; a < radii.size(); ++a) {
      const double angle = 2 * kPi * static_cast<double>(a) / static_cast<double>(radii.size());
      ring.push_back(plan.centre + radii[a] * Vec2{std::cos(angle), std::sin(angle)});
    }
    out.areas[i] = {{std::move(ring), {}}};
  }
  out.lobes = find_lobes(land_of(out));
  return out;
}

RegionWidths natural_widths(double land_m2) {
  const double radius = std::sqrt(land_m2 / kPi);
  return {std::clamp(0.012 * radius, 20.0, 220.0), std::clamp(0.09 * radius, 80.0, 2200.0),
          std::clamp(0.07 * radius, 80.0, 1500.0), std::clamp(0.55 * radius, 600.0, 14000.0)};
}

std::vector<double> resample_radii(const std::vector<double>& radii, int count) {
  const auto n = static_cast<int>(radii.size());
  std::vector<double> out(static_cast<size_t>(count));
  for (int k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) * n / count;
    const int i = static_cast<int>(t);
    const double f = t - i;
    const auto at = [&](int j) { return radii[static_cast<size_t>(((i + j) % n + n) % n)]; };
    const double a = at(-1), b = at(0), c = at(1), d = at(2);
    out[static_cast<size_t>(k)] = b + 0.5 * f * (c - a + f * (2 * a - 5 * b + 4 * c - d + f * (3 * (b - c) + d - a)));
  }
  return out;
}

Plan plan_from_polar(std::vector<PolarOutline> outlines, Vec2 centre, const GivenWidths& widths) {
  if (outlines.size() != 1 && outlines.size() != kOutlineCount) {
    throw InvalidArgument(
        "outlines", fmt::format("{} outlines; give one (the coast) or five (mountain, beach, lagoon, reef, abyss)",
                                outlines.size()));
  }
  for (size_t i = 0; i < outlines.size(); ++i) {
    for (const double r : outlines[i].radii_m) {
      if (!(r > 0) || !std::isfinite(r))
        throw InvalidArgument("outlines",
                              fmt::format("outline {} has the radius {}; radii are above 0", i + 1, format_number(r)));
    }
    if (outlines[i].radii_m.empty()) throw InvalidArgument("outlines", fmt::format("outline {} has no radius", i + 1));
    outlines[i].radii_m = resample_radii(outlines[i].radii_m, kPolarSamples);
  }
  Plan plan;
  plan.centre = centre;
  const std::vector<double>& coast = outlines.size() == 1 ? outlines[0].radii_m : outlines[kCoast].radii_m;
  plan.land_m2 = polar_area(coast);
  plan.lobes = {{centre, std::sqrt(plan.land_m2 / kPi)}};
  plan.widths = complete_widths(plan.land_m2, widths);
  plan.derived = outlines.size() == 1;
  if (plan.derived) {
    const RegionWidths& w = plan.widths;
    const std::array<double, kOutlineCount> offset = {0, 0, w.lagoon_m, w.lagoon_m + w.reef_m,
                                                      w.lagoon_m + w.reef_m + w.slope_m};
    const PolarOutline given = outlines[0];
    outlines.assign(kOutlineCount, given);
    for (size_t i = 0; i < outlines.size(); ++i) {
      for (double& r : outlines[i].radii_m) r = i == 0 ? std::max(0.2 * r, r - w.beach_m) : r + offset[i];
    }
  }
  check_order(outlines);
  plan.polar = std::move(outlines);
  return plan;
}

namespace {

/// The areas of a drawing and those that its lines enclose, as coastline ways do.
std::vector<NamedArea> all_areas(const Drawing& drawing, const std::string& name) {
  std::vector<NamedArea> areas = drawing.areas;
  geom::LineAreas found = geom::areas_from_lines(drawing.lines);
  if (areas.empty() && !found.open.empty()) {
    const Polyline& line = found.open[0].points;
    throw InvalidArgument(name, "a line runs from " + geom::format_place(line.front()) + " to " +
                                    geom::format_place(line.back()) +
                                    " and does not close; a coast is an area or closed");
  }
  areas.insert(areas.end(), std::make_move_iterator(found.areas.begin()), std::make_move_iterator(found.areas.end()));
  return areas;
}

}  // namespace

Plan plan_from_areas(const Drawing& drawing, const GivenWidths& widths, const std::string& name) {
  Plan plan;
  plan.crs = drawing.crs;
  bool named = false;
  const std::vector<NamedArea> areas = all_areas(drawing, name);
  for (const NamedArea& area : areas) {
    for (int i = 0; i < kOutlineCount; ++i) named = named || area.name == kAreaNames[i];
  }
  for (const NamedArea& area : areas) {
    for (Polygon part : area.parts) {
      if (const auto defect = geom::find_defect(part)) {
        throw InvalidArgument(name, (area.name.empty() ? "" : "'" + area.name + "': ") + *defect);
      }
      geom::orient(part);
      for (int i = 0; i < kOutlineCount; ++i) {
        if (named ? area.name == kAreaNames[i] : i == kCoast) plan.areas[i].push_back(part);
      }
    }
  }
  if (land_of(plan).empty()) throw InvalidArgument(name, "holds no area");
  check_nesting(plan, name);
  measure(plan, widths);
  return plan;
}

Plan plan_from_labels(const LabelMap& labels, const GivenWidths& widths, const RunContext& run) {
  Plan plan;
  plan.crs = labels.frame().crs;
  Grid<uint8_t> inside(labels.frame());
  int64_t previous = 0;
  // Outline 5 is not painted: abyss is what lies beyond the reef.
  for (int i = 0; i + 1 < kOutlineCount; ++i) {
    run.check_cancelled();
    int64_t count = 0;
    for (size_t c = 0; c < labels.size(); ++c) {
      const bool within = static_cast<int>(labels.cells()[c]) <= i;
      inside.cells()[c] = within ? 1 : 0;
      count += within ? 1 : 0;
    }
    // A region nobody painted has the same area as the one inside it: leave it to be derived.
    if (count > previous) plan.areas[i] = geom::trace_mask(inside, run);
    previous = count;
  }
  if (previous == 0) throw InvalidArgument("labels", "all of it is abyss: paint an island");
  measure(plan, widths);
  return plan;
}

Plan random_plan(const GridFrame& frame, Vec2 centre, double irregularity, Seed seed, const GivenWidths& widths) {
  const double radius = 0.26 * std::min(frame.width_m(), frame.height_m());
  PolarOutline coast;
  coast.radii_m.resize(kPolarSamples);
  for (int a = 0; a < kPolarSamples; ++a) {
    const double noise = geom::fbm_circle(seed.derive("island.coast"), 2 * kPi * a / kPolarSamples, 3.0, 5);
    coast.radii_m[static_cast<size_t>(a)] = radius * std::max(0.3, 1.0 + irregularity * noise);
  }
  Plan plan = plan_from_polar({coast}, centre, widths);
  plan.detail_m = 0.028 * plan.lobes.front().radius_m;
  return plan;
}

Extent extent_of(const Plan& plan) {
  Extent extent{plan.crs, 1e300, 1e300, -1e300, -1e300};
  const auto include = [&](Vec2 p) { extent.include({{}, p.x, p.y, p.x, p.y}); };
  if (!plan.polar.empty()) {
    const std::vector<double>& radii = plan.polar[kCoast].radii_m;
    for (size_t a = 0; a < radii.size(); ++a) {
      const double angle = 2 * kPi * static_cast<double>(a) / static_cast<double>(radii.size());
      include(plan.centre + radii[a] * Vec2{std::cos(angle), std::sin(angle)});
    }
  } else {
    for (const Polygon& polygon : land_of(plan)) {
      for (const Vec2 p : polygon.outer) include(p);
    }
  }
  return extent;
}

namespace {

bool holds(const GridFrame& frame, const Extent& coast) {
  return coast.west > frame.west_m && coast.east < frame.east_m() && coast.south > frame.south_m() &&
         coast.north < frame.north_m;
}

/// Half of the side that a domain around `middle` needs from `low` to `high`, in whole hundreds of metres for the side.
double half_side(const Plan& plan, double middle, double low, double high) {
  const double slope = plan.widths.lagoon_m + plan.widths.reef_m + plan.widths.slope_m;
  return 50.0 * std::ceil(0.02 * (std::max(middle - low, high - middle) + slope));
}

}  // namespace

GridFrame frame_around(const Plan& plan, const GridFrame& domain) {
  const Extent coast = extent_of(plan);
  if (holds(domain, coast)) return domain;
  const Vec2 middle{0.5 * (coast.west + coast.east), 0.5 * (coast.south + coast.north)};
  const double width = 2 * half_side(plan, middle.x, coast.west, coast.east);
  const double height = 2 * half_side(plan, middle.y, coast.south, coast.north);
  GridFrame frame = domain;
  frame.cell_m = std::max(width, height) / std::max(domain.width, domain.height);
  frame.width = std::max(1, static_cast<int>(std::lround(width / frame.cell_m)));
  frame.height = std::max(1, static_cast<int>(std::lround(height / frame.cell_m)));
  frame.west_m = middle.x - 0.5 * frame.width_m();
  frame.north_m = middle.y + 0.5 * frame.height_m();
  return frame;
}

void check_fits(const Plan& plan, const GridFrame& frame, const std::string& name) {
  const Extent coast = extent_of(plan);
  const double across = std::max(coast.east - coast.west, coast.north - coast.south);
  if (plan.polar.empty() && across < 2 * frame.cell_m)
    throw InvalidArgument(name, fmt::format("the island is {:.3g} m across, less than two cells of {:.3g} m; are its "
                                            "coordinates metres?",
                                            across, frame.cell_m));
  if (holds(frame, coast)) return;
  const double x = frame.west_m + 0.5 * frame.width_m(), y = frame.north_m - 0.5 * frame.height_m();
  throw InvalidArgument(
      name,
      fmt::format(
          "the coast reaches from x = {:.0f} to {:.0f} m and y = {:.0f} to {:.0f} m and touches the edge of the "
          "domain ({:.0f} to {:.0f}, {:.0f} to {:.0f}); with its reef it fits into width_m = {:.0f}, height_m = {:.0f}",
          coast.west, coast.east, coast.south, coast.north, frame.west_m, frame.east_m(), frame.south_m(),
          frame.north_m, 2 * half_side(plan, x, coast.west, coast.east),
          2 * half_side(plan, y, coast.south, coast.north)));
}

}  // namespace seamount::island
