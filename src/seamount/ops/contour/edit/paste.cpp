// Laying a pattern over contours, and taking ground away (pattern.h).
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/model/extent.h"
#include "seamount/ops/contour/edit/edit_area.h"
#include "seamount/ops/contour/edit/lay_ground.h"
#include "seamount/ops/contour/edit/match.h"
#include "seamount/ops/contour/edit/outflow.h"
#include "seamount/ops/contour/edit/pattern.h"
#include "seamount/ops/contour/edit/selection.h"

namespace seamount::contour {
namespace {

/// A place inside a ring: half way along the longest stretch of the line that halves its height.
Vec2 place_inside(const Ring& ring) {
  const geom::Box box = geom::bounding_box(ring);
  const double y = 0.5 * (box.low.y + box.high.y);
  std::vector<double> crossings;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
  }
  std::sort(crossings.begin(), crossings.end());
  Vec2 place = 0.5 * (box.low + box.high);
  double longest = 0.0;
  for (size_t i = 0; i + 1 < crossings.size(); i += 2) {
    if (crossings[i + 1] - crossings[i] <= longest) continue;
    longest = crossings[i + 1] - crossings[i];
    place = {crossings[i] + 0.5 * longest, y};
  }
  return place;
}

/// A place within the highest contour around a hill, of several within the largest.
Vec2 highest_place(const ContourSet& set) {
  const Contour* highest = nullptr;
  double area = 0.0;
  for (const Contour& contour : set.contours) {
    const double own = geom::signed_area(contour.ring);
    if (own <= 0) continue;
    if (highest != nullptr && std::pair(contour.height_m, own) <= std::pair(highest->height_m, area)) continue;
    highest = &contour;
    area = own;
  }
  return highest == nullptr ? Extent::of(set.frame).middle() : place_inside(highest->ring);
}

/// Where the pattern's middle comes to lie. Throws InvalidArgument{name.at}: outside the domain.
Vec2 place_of(const PasteTool& tool, const ContourSet& set, const std::string& name) {
  if (!tool.at) return tool.on == PasteOn::highest ? highest_place(set) : Extent::of(set.frame).middle();
  const Extent domain = Extent::of(set.frame);
  if (!domain.contains(*tool.at))
    throw InvalidArgument(name + ".at",
                          metres_text(*tool.at) + " lies outside the domain, which covers " + extent_text(domain));
  return *tool.at;
}

Placement placement_of(const PasteTool& tool, Vec2 at) {
  const double angle = tool.rotation_deg * std::numbers::pi / 180.0;
  return {.from = {}, .at = at, .turn = {std::cos(angle), std::sin(angle)}, .scale = tool.scale};
}

Ring to_world(const Placement& placement, const Ring& ring) {
  Ring out;
  for (const Vec2 p : ring) out.push_back(placement.to_world(p));
  return out;
}

}  // namespace

void paste_pattern(const Drawing& pattern, const PasteTool& tool, ContourSet& set, const std::string& name,
                   const RunContext& run) {
  const Placement placement = placement_of(tool, place_of(tool, set, name));
  const Polygon& own = pattern.areas[0].parts[0];
  Polygon outline{to_world(placement, own.outer), {}};
  for (const Ring& hole : own.holes) outline.holes.push_back(to_world(placement, hole));
  const EditArea area = make_edit_area(set, outline, false, surroundings(outline), name, run);
  const ScalarField relief = pattern_ground(pattern, run);
  const GridFrame& frame = area.patch.nodes;
  ScalarField laid(frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const Vec2 p = placement.to_source({frame.x(x), frame.y(y)});
        laid(x, y) = static_cast<float>(tool.height_scale) *
                     geom::sample_bicubic(relief, relief.frame().column(p.x), relief.frame().row(p.y));
      }
    }
  });
  const ScalarField heights =
      lay_ground(area, laid, tool.raise_m, tool.blend_m.value_or(kSoftRim * half_width(area)), run);
  say_ponds(name + " (paste)", {}, find_ponds(area, heights, min_gap(levels_of(set)), run), run);
  replace_area(set, area, heights, name, run);
}

void clear_outline(const Outline& outline, ContourSet& set, const std::string& name, const RunContext& run) {
  if (outline.contour >= 0) {
    std::vector<char> gone(set.contours.size(), 0);
    gone[static_cast<size_t>(outline.contour)] = 1;
    for (size_t i = 0; i < gone.size(); ++i) {
      const int parent = set.contours[i].parent;
      if (parent >= 0 && gone[static_cast<size_t>(parent)] != 0) gone[i] = 1;
    }
    return remove_contours(set, gone);
  }
  const EditArea area =
      make_edit_area(set, outline.polygon, false, surroundings(outline.polygon), name + ".within", run);
  const double gap = min_gap(levels_of(set));
  ScalarField heights = close_ground(area, run);
  const std::vector<Pond> cut = let_water_out(area, heights, gap, run);
  say_ponds(name + " (cut)", cut, find_ponds(area, heights, gap, run), run);
  replace_area(set, area, heights, name + ".within", run);
}

}  // namespace seamount::contour
