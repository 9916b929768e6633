#include "seamount/ops/contour/edit/lay_ground.h"

#include <algorithm>
#include <cmath>

#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/solve/poisson.h"
#include "seamount/geom/solve/thin_plate.h"
#include "seamount/ops/contour/edit/lattice_heights.h"

namespace seamount::contour {
namespace {

/// Extends values given at the nodes that are at most half a cell within the outline smoothly over it.
void stretch_membrane(ScalarField& values, const ScalarField& inward, const RunContext& run) {
  Grid<uint8_t> fixed(inward.frame(), 0);
  const auto rim = static_cast<float>(0.5 * inward.cell_m());
  for (size_t i = 0; i < inward.size(); ++i) fixed.cells()[i] = inward.cells()[i] <= rim ? 1 : 0;
  geom::solve_laplace(values, fixed, run);
}

}  // namespace

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

double half_width(const EditArea& area) {
  return static_cast<double>(*std::max_element(area.inward.cells().begin(), area.inward.cells().end()));
}

ScalarField lay_ground(const EditArea& area, const ScalarField& laid, double raise_m, double blend_m,
                       const RunContext& run) {
  ScalarField fit = area.ground;
  for (size_t i = 0; i < fit.size(); ++i) fit.cells()[i] -= laid.cells()[i];
  stretch_membrane(fit, area.inward, run);
  ScalarField heights = area.ground;
  const double width = std::max(blend_m, heights.cell_m());
  for (size_t i = 0; i < heights.size(); ++i) {
    const float share = static_cast<float>(geom::smoothstep(static_cast<double>(area.inward.cells()[i]) / width));
    const float wanted = laid.cells()[i] + fit.cells()[i] + static_cast<float>(raise_m);
    heights.cells()[i] += share * (wanted - heights.cells()[i]);
  }
  return heights;
}

ScalarField close_ground(const EditArea& area, const RunContext& run) {
  constexpr int kSweeps = 160;  // a plate's stiffness reaches half as many nodes in from the rim
  ScalarField heights = area.ground;
  stretch_membrane(heights, area.inward, run);
  const auto [least, most] = std::minmax_element(heights.cells().begin(), heights.cells().end());
  ScalarField low(heights.frame(), *least);
  ScalarField high(heights.frame(), *most);
  for (size_t i = 0; i < heights.size(); ++i)
    if (area.inward.cells()[i] <= 0.0F) low.cells()[i] = high.cells()[i] = area.ground.cells()[i];
  return geom::smooth_thin_plate(std::move(heights), low, high, kSweeps, run);
}

void replace_area(ContourSet& set, const EditArea& area, const ScalarField& heights, const std::string& name,
                  const RunContext& run) {
  const auto [low, high] = std::minmax_element(heights.cells().begin(), heights.cells().end());
  const std::vector<double> levels =
      levels_covering(levels_of(set), static_cast<double>(*low), static_cast<double>(*high), name);
  replace_patch(set, area.patch, heights, levels, name, run);
}

}  // namespace seamount::contour
