// Regions from the areas and lines of a drawing (regions.h).
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "seamount/base/error.h"
#include "seamount/geom/polygon/joined_lines.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/contour/growth/regions.h"

namespace seamount::contour {
namespace {

std::string part_name(const std::string& name, const std::string& kind, size_t number, size_t parts, size_t part) {
  std::string text = name.empty() ? fmt::format("{} {}", kind, number) : name;
  if (parts > 1) text += fmt::format(" (part {})", part);
  return text;
}

/// The number that a feature carries under a name, in any letter case.
std::optional<double> number_of(const Attributes& attributes, std::string_view name) {
  for (const Attribute& attribute : attributes) {
    const bool same = std::equal(attribute.name.begin(), attribute.name.end(), name.begin(), name.end(),
                                 [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
    if (same) return attribute.value;
  }
  return std::nullopt;
}

/// A hole that touches its shell in a place is sound, but outlines of regions stay apart: it is drawn in by a
/// thousandth.
Ring apart_from(const Ring& hole, const Polygon& polygon) {
  constexpr double kShrink = 1e-3;
  if (!geom::find_crossing(polygon.outer, hole) || geom::find_defect(polygon)) return hole;
  Vec2 middle;
  for (const Vec2 p : hole) middle = middle + (1.0 / static_cast<double>(hole.size())) * p;
  Ring moved;
  for (const Vec2 p : hole) moved.push_back(p + kShrink * (middle - p));
  return moved;
}

std::vector<GrowthRegion> regions_of_areas(const std::vector<NamedArea>& areas) {
  std::vector<GrowthRegion> regions;
  for (size_t a = 0; a < areas.size(); ++a) {
    const NamedArea& area = areas[a];
    const auto height = number_of(area.attributes, "height_m"), peak = number_of(area.attributes, "peak_m");
    const bool basin = number_of(area.attributes, "basin").value_or(0.0) != 0.0;
    for (size_t p = 0; p < area.parts.size(); ++p) {
      const std::string name = part_name(area.name, "area", a, area.parts.size(), p);
      regions.push_back({name, area.parts[p].outer, -1, height, basin, peak});
      for (size_t h = 0; h < area.parts[p].holes.size(); ++h)
        regions.push_back({fmt::format("{} (hole {})", name, h), apart_from(area.parts[p].holes[h], area.parts[p]), -1,
                           std::nullopt, true});
    }
  }
  return regions;
}

/// Adds what lines enclose; the heights of lines are given only where they mean something.
void add_lines(const std::vector<ValuedLine>& lines, bool heights, const std::string& field,
               std::vector<GrowthRegion>& regions) {
  constexpr double kRounding = 1e-9;
  double largest = 0.0;
  for (const ValuedLine& line : lines)
    for (const Vec2 p : line.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  const std::vector<ValuedLine> joined = geom::join_lines(lines, true, kRounding * largest);
  for (size_t i = 0; i < joined.size(); ++i) {
    const ValuedLine& line = joined[i];
    if (!line.closed && !line.points.empty() && !(line.points.front() == line.points.back())) {
      throw InvalidArgument(
          field, fmt::format("line {} is open: it begins at {} and ends at {}; a region's outline is closed", i,
                             geom::format_place(line.points.front()), geom::format_place(line.points.back())));
    }
    const std::optional<double> height = heights ? std::optional<double>(line.value) : std::nullopt;
    regions.push_back({fmt::format("line {}", i), line.points, -1, height, false});
  }
}

}  // namespace

RegionTree regions_from_drawing(const Drawing& drawing, const GridFrame& domain, const std::string& field) {
  std::vector<GrowthRegion> regions = regions_of_areas(drawing.areas);
  const bool heights =
      std::any_of(drawing.lines.begin(), drawing.lines.end(), [](const ValuedLine& line) { return line.value != 0.0; });
  const size_t first_line = regions.size();
  add_lines(drawing.lines, heights, field, regions);
  if (!heights) return nest_regions(std::move(regions), domain, field);
  // Which lines are depressions shows once they are nested: take the heights off, nest, and put them back.
  std::vector<std::pair<std::string, std::optional<double>>> given;
  for (size_t i = first_line; i < regions.size(); ++i) {
    given.emplace_back(regions[i].name, std::exchange(regions[i].height_m, std::nullopt));
  }
  RegionTree tree = nest_regions(std::move(regions), domain, field);
  for (GrowthRegion& region : tree.regions) {
    const auto found = std::find_if(given.begin(), given.end(), [&](const auto& g) { return g.first == region.name; });
    if (found == given.end()) continue;
    region.height_m = found->second;
    const GrowthRegion* around = region.parent < 0 ? nullptr : &tree.regions[static_cast<size_t>(region.parent)];
    if (around == nullptr || !around->height_m) continue;
    region.basin = *region.height_m < *around->height_m || (!around->basin && *region.height_m == *around->height_m);
  }
  for (size_t i = 0; i < tree.regions.size(); ++i) check_region_height(tree.regions, i, field);
  return tree;
}

}  // namespace seamount::contour
