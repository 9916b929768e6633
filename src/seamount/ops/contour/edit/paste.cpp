// Laying a pattern over contours, and taking ground away (pattern.h).
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/solve/poisson.h"
#include "seamount/ops/contour/edit/edit_area.h"
#include "seamount/ops/contour/edit/lattice_heights.h"
#include "seamount/ops/contour/edit/pattern.h"
#include "seamount/ops/contour/edit/selection.h"

namespace seamount::contour {
namespace {

/// Where a pattern lies in the world.
struct Placement {
  Vec2 at;
  Vec2 turn;  ///< unit vector of the pattern's east
  double scale;

  explicit Placement(const PasteTool& tool) : at(tool.at), scale(tool.scale) {
    const double angle = tool.rotation_deg * std::numbers::pi / 180.0;
    turn = {std::cos(angle), std::sin(angle)};
  }
  Vec2 to_world(Vec2 p) const { return at + scale * Vec2{turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y}; }
  Vec2 to_pattern(Vec2 p) const {
    const Vec2 d = (1.0 / scale) * (p - at);
    return {turn.x * d.x + turn.y * d.y, turn.x * d.y - turn.y * d.x};
  }
};

Ring to_world(const Placement& placement, const Ring& ring) {
  Ring out;
  for (const Vec2 p : ring) out.push_back(placement.to_world(p));
  return out;
}

ScalarField pattern_ground(const Drawing& pattern, const RunContext& run) {
  const geom::Box box = geom::bounding_box(pattern.areas[0].parts[0].outer);
  double length = 0.0;
  double edges = 0.0;
  std::vector<double> levels;
  for (const ValuedLine& line : pattern.lines) {
    length += line.closed ? geom::ring_length(line.points) : geom::line_length(line.points);
    edges += static_cast<double>(line.points.size());
    levels.push_back(line.value);
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const double cell = lattice_cell(extent, length / edges);
  constexpr int kMargin = 4;
  GridFrame frame;
  frame.cell_m = cell;
  frame.west_m = box.low.x - kMargin * cell;
  frame.north_m = box.high.y + kMargin * cell;
  frame.width = static_cast<int>(std::ceil((box.high.x - box.low.x) / cell)) + 2 * kMargin;
  frame.height = static_cast<int>(std::ceil((box.high.y - box.low.y) / cell)) + 2 * kMargin;
  return lattice_heights(level_lines(pattern), frame, min_gap(levels), 0.0, run);
}

/// Extends values given at the nodes that are at most half a cell within the outline smoothly over it.
void stretch_membrane(ScalarField& values, const ScalarField& inward, const RunContext& run) {
  Grid<uint8_t> fixed(inward.frame(), 0);
  const auto rim = static_cast<float>(0.5 * inward.cell_m());
  for (size_t i = 0; i < inward.size(); ++i) fixed.cells()[i] = inward.cells()[i] <= rim ? 1 : 0;
  geom::solve_laplace(values, fixed, run);
}

void replace(ContourSet& set, const EditArea& area, const ScalarField& heights, const std::string& name,
             const RunContext& run) {
  const auto [low, high] = std::minmax_element(heights.cells().begin(), heights.cells().end());
  const std::vector<double> levels =
      levels_covering(levels_of(set), static_cast<double>(*low), static_cast<double>(*high), name);
  replace_patch(set, area.patch, heights, levels, name, run);
}

}  // namespace

void paste_pattern(const Drawing& pattern, const PasteTool& tool, ContourSet& set, const std::string& name,
                   const RunContext& run) {
  const Placement placement(tool);
  const Polygon& own = pattern.areas[0].parts[0];
  Polygon outline{to_world(placement, own.outer), {}};
  for (const Ring& hole : own.holes) outline.holes.push_back(to_world(placement, hole));
  const EditArea area = make_edit_area(set, outline, false, 0.0, name, run);
  const ScalarField relief = pattern_ground(pattern, run);
  const GridFrame& frame = area.patch.nodes;
  ScalarField laid(frame);
  ScalarField fit(frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const Vec2 p = placement.to_pattern({frame.x(x), frame.y(y)});
        laid(x, y) = static_cast<float>(tool.height_scale) *
                     geom::sample_bicubic(relief, relief.frame().column(p.x), relief.frame().row(p.y));
        fit(x, y) = area.ground(x, y) - laid(x, y);
      }
    }
  });
  stretch_membrane(fit, area.inward, run);
  ScalarField heights = area.ground;
  const double width = std::max(tool.blend_m, frame.cell_m);
  for (size_t i = 0; i < heights.size(); ++i) {
    const float share = static_cast<float>(geom::smoothstep(static_cast<double>(area.inward.cells()[i]) / width));
    const float pasted = laid.cells()[i] + fit.cells()[i] + static_cast<float>(tool.raise_m);
    heights.cells()[i] += share * (pasted - heights.cells()[i]);
  }
  replace(set, area, heights, name, run);
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
  const EditArea area = make_edit_area(set, outline.polygon, false, 0.0, name, run);
  ScalarField heights = area.ground;
  stretch_membrane(heights, area.inward, run);
  replace(set, area, heights, name, run);
}

}  // namespace seamount::contour
