#include "seamount/ops/contour/growth/regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/text.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::contour {
namespace {

constexpr double kHighest = 20000.0;

std::string quoted(const GrowthRegion& region) { return "'" + region.name + "'"; }

/// Without points that repeat the one before, or the first at the end.
Ring without_repeats(const Ring& ring) {
  Ring clean;
  for (const Vec2 p : ring) {
    if (clean.empty() || !(clean.back() == p)) clean.push_back(p);
  }
  while (clean.size() > 1 && clean.back() == clean.front()) clean.pop_back();
  return clean;
}

void check_alone(const GrowthRegion& region, const std::string& field) {
  // The defect speaks of an outer ring, which a region calls its outline.
  if (std::optional<std::string> defect = geom::find_defect(Polygon{region.outline, {}})) {
    for (size_t at = defect->find("outer ring"); at != std::string::npos; at = defect->find("outer ring")) {
      defect->replace(at, 10, "outline");
    }
    throw InvalidArgument(field, quoted(region) + ": " + *defect);
  }
  for (const auto& [what, height] : {std::pair{"height", region.height_m}, {"peak", region.peak_m}}) {
    if (height && !(std::abs(*height) <= kHighest)) {
      throw InvalidArgument(field, fmt::format("{}: {} {} m is outside {}", quoted(region), what,
                                               format_number(*height), format_range(-kHighest, kHighest)));
    }
  }
  if (!region.height_m || !region.peak_m) return;
  if (region.basin ? *region.peak_m < *region.height_m : *region.peak_m > *region.height_m) return;
  throw InvalidArgument(field, fmt::format("{}: its peak at {} m is not {} than its outline at {} m", quoted(region),
                                           format_number(*region.peak_m), region.basin ? "lower" : "higher",
                                           format_number(*region.height_m)));
}

std::vector<Contour> outlines_of(const std::vector<GrowthRegion>& regions) {
  std::vector<Contour> outlines;
  outlines.reserve(regions.size());
  for (const GrowthRegion& region : regions) outlines.push_back({0.0, region.outline, -1});
  return outlines;
}

void check_apart(const std::vector<GrowthRegion>& regions, const std::string& field, const RunContext& run) {
  const std::optional<geom::ContourCrossing> meeting = geom::find_contour_crossing(outlines_of(regions), run);
  if (!meeting) return;
  throw InvalidArgument(field, fmt::format("{} and {} overlap without nesting: their outlines cross or touch at {}; "
                                           "draw one inside the other or apart from it",
                                           quoted(regions[meeting->first]), quoted(regions[meeting->second]),
                                           geom::format_place(meeting->at)));
}

Ring frame_ring(const GridFrame& frame) {
  return {{frame.west_m, frame.south_m()},
          {frame.east_m(), frame.south_m()},
          {frame.east_m(), frame.north_m},
          {frame.west_m, frame.north_m}};
}

bool boxes_meet(const geom::Box& a, const geom::Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

bool box_holds(const geom::Box& outer, const geom::Box& inner) {
  return outer.low.x <= inner.low.x && outer.low.y <= inner.low.y && outer.high.x >= inner.high.x &&
         outer.high.y >= inner.high.y;
}

void check_meets_domain(const GrowthRegion& region, const GridFrame& domain, const std::string& field) {
  const geom::Box box = geom::bounding_box(region.outline);
  const Ring ring = frame_ring(domain);
  const geom::Box frame = geom::bounding_box(ring);
  if (box_holds(frame, box)) return;
  const auto meets = [&] {
    return geom::contains(region.outline, ring[0]) || geom::contains(ring, region.outline[0]) ||
           geom::find_crossing(region.outline, ring).has_value();
  };
  if (boxes_meet(frame, box) && meets()) return;
  throw InvalidArgument(
      field, fmt::format("{} lies wholly outside the domain: it begins at {}, the domain reaches from {} to {}",
                         quoted(region), geom::format_place(region.outline[0]), geom::format_place(frame.low),
                         geom::format_place(frame.high)));
}

/// The mean width of each region: twice its area over the length of its outlines.
std::vector<double> mean_widths(const std::vector<GrowthRegion>& regions) {
  std::vector<double> areas(regions.size(), 0.0);
  std::vector<double> lengths(regions.size(), 0.0);
  for (size_t i = 0; i < regions.size(); ++i) {
    const double area = std::abs(geom::signed_area(regions[i].outline));
    const double length = geom::ring_length(regions[i].outline);
    areas[i] += area;
    lengths[i] += length;
    if (regions[i].parent < 0) continue;
    areas[static_cast<size_t>(regions[i].parent)] -= area;
    lengths[static_cast<size_t>(regions[i].parent)] += length;
  }
  std::vector<double> widths(regions.size(), 0.0);
  for (size_t i = 0; i < widths.size(); ++i) widths[i] = 2.0 * std::max(areas[i], 0.0) / lengths[i];
  return widths;
}

/// A summit or a floor does not reach the next level, or a contour would show it. Within that bound it goes on at the
/// slope of the ground around its outline; over the highest level and under the lowest nothing bounds it.
void set_contour_peaks(std::vector<GrowthRegion>& regions) {
  constexpr double kMostShare = 0.85;  // of the way to the next level
  std::vector<double> levels;
  std::vector<char> ends(regions.size(), 1);
  for (const GrowthRegion& r : regions) {
    levels.push_back(*r.height_m);
    if (r.parent >= 0 && regions[static_cast<size_t>(r.parent)].basin == r.basin)
      ends[static_cast<size_t>(r.parent)] = 0;
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  const std::vector<double> widths = mean_widths(regions);
  for (size_t i = 0; i < regions.size(); ++i) {
    GrowthRegion& r = regions[i];
    const auto own = std::lower_bound(levels.begin(), levels.end(), *r.height_m);
    if (ends[i] == 0 || (r.basin ? own == levels.begin() : own + 1 == levels.end())) continue;
    const double gap = r.basin ? *std::prev(own) - *own : *std::next(own) - *own;
    // The middle of a region lies about its mean width from its outline; the ground around crosses a gap in its own.
    const double around = r.parent < 0 ? 0.0 : widths[static_cast<size_t>(r.parent)];
    const double steps = around > 0.0 ? widths[i] / (kMostShare * around) : 1.0;
    r.peak_m = *own + kMostShare * gap * steps / std::sqrt(1.0 + steps * steps);
  }
}

}  // namespace

void check_region_height(const std::vector<GrowthRegion>& regions, size_t child, const std::string& field) {
  const GrowthRegion& region = regions[child];
  if (!region.height_m) return;
  for (int i = region.parent; i >= 0; i = regions[static_cast<size_t>(i)].parent) {
    const GrowthRegion& around = regions[static_cast<size_t>(i)];
    if (around.basin != region.basin) return;
    if (!around.height_m) continue;
    if (region.basin ? *region.height_m < *around.height_m : *region.height_m > *around.height_m) return;
    throw InvalidArgument(
        field, fmt::format("{} at {} m (near {}) is not {} than {} at {} m around it{}", quoted(region),
                           format_number(*region.height_m), geom::format_place(region.outline[0]),
                           region.basin ? "lower" : "higher", quoted(around), format_number(*around.height_m),
                           region.basin ? "" : "; if it is to be a basin, say so"));
  }
}

RegionTree nest_regions(std::vector<GrowthRegion> regions, const GridFrame& domain, const std::string& field,
                        const RunContext& run) {
  if (regions.empty()) throw InvalidArgument(field, "no regions: give at least one closed outline");
  for (size_t i = 0; i < regions.size(); ++i) {
    run.check_cancelled();
    if (regions[i].name.empty()) regions[i].name = fmt::format("region {}", i);
    regions[i].outline = without_repeats(regions[i].outline);
    check_alone(regions[i], field);
    if (geom::signed_area(regions[i].outline) < 0.0) {
      std::reverse(regions[i].outline.begin(), regions[i].outline.end());
    }
  }
  check_apart(regions, field, run);
  std::stable_sort(regions.begin(), regions.end(), [](const GrowthRegion& a, const GrowthRegion& b) {
    return geom::signed_area(a.outline) > geom::signed_area(b.outline);
  });
  const std::vector<int> parents = geom::find_contour_parents(outlines_of(regions), run);
  for (size_t i = 0; i < regions.size(); ++i) {
    run.check_cancelled();
    check_meets_domain(regions[i], domain, field);
    regions[i].parent = parents[i];
    if (regions[i].basin && parents[i] < 0) {
      throw InvalidArgument(field, fmt::format("the basin {} (near {}) lies in no region; draw the land around it",
                                               quoted(regions[i]), geom::format_place(regions[i].outline[0])));
    }
    check_region_height(regions, i, field);
  }
  return {std::move(regions)};
}

RegionTree regions_from_outlines(const std::vector<RegionOutline>& outlines, const GridFrame& domain,
                                 const std::string& field) {
  std::vector<GrowthRegion> regions;
  regions.reserve(outlines.size());
  for (const RegionOutline& drawn : outlines) {
    regions.push_back({drawn.name, drawn.ring, -1, drawn.height_m, drawn.basin, drawn.peak_m});
  }
  return nest_regions(std::move(regions), domain, field);
}

RegionTree regions_from_contours(const ContourSet& set, const GridFrame& domain, const std::string& field,
                                 const RunContext& run) {
  std::vector<GrowthRegion> regions;
  for (size_t i = 0; i < set.contours.size(); ++i) {
    const Contour& contour = set.contours[i];
    regions.push_back({fmt::format("contour {} at {} m", i, format_number(contour.height_m)), contour.ring, -1,
                       contour.height_m, geom::signed_area(contour.ring) < 0.0});
  }
  RegionTree tree = nest_regions(std::move(regions), domain, field, run);
  set_contour_peaks(tree.regions);
  return tree;
}

std::vector<TinRegion> tin_regions(const RegionTree& tree) {
  std::vector<TinRegion> regions;
  for (const GrowthRegion& r : tree.regions)
    regions.push_back({r.name, r.parent, r.outline, r.height_m, r.basin, r.peak_m});
  return regions;
}

RegionTree regions_of(const Tin& tin) {
  RegionTree tree;
  for (const TinRegion& r : tin.regions) {
    if (r.outline.empty()) throw IncompatibleInputs("tin: region '" + r.name + "' has no outline");
    tree.regions.push_back({r.name, r.outline, r.parent, r.height_m, r.basin, r.peak_m});
  }
  if (tree.regions.empty()) throw IncompatibleInputs("tin: it has no regions; make it with contour.grow");
  return tree;
}

}  // namespace seamount::contour
