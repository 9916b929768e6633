#include "seamount/ops/contour/edit/edit_area.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/contour/edit/lattice_heights.h"
#include "seamount/ops/contour/move/places.h"

namespace seamount::contour {
namespace {

constexpr int kMargin = 6;  ///< cells around the outline, at least

/// A lattice over a box; `attempt` shifts it so that no contour meets a corner.
GridFrame lattice(const geom::Box& box, double cell, int attempt, const std::string& crs) {
  const double shift = std::fmod(0.1371 + 0.2718281828 * attempt, 1.0);
  GridFrame frame;
  frame.cell_m = cell;
  frame.west_m = box.low.x - (kMargin + shift) * cell;
  frame.north_m = box.high.y + (kMargin + std::fmod(shift * 1.618033988, 1.0)) * cell;
  frame.width = static_cast<int>(std::ceil((box.high.x - frame.west_m) / cell)) + kMargin;
  frame.height = static_cast<int>(std::ceil((frame.north_m - box.low.y) / cell)) + kMargin;
  frame.crs = crs;
  return frame;
}

Patch patch_of(const ScalarField& inward, double least_m) {
  Patch patch(inward.frame());
  for (int y = 0; y < patch.squares.height(); ++y) {
    for (int x = 0; x < patch.squares.width(); ++x) {
      const float most = std::max({inward(x, y), inward(x + 1, y), inward(x, y + 1), inward(x + 1, y + 1)});
      patch.squares(x, y) = static_cast<double>(most) > least_m ? 1 : 0;
    }
  }
  return patch;
}

ScalarField inward_distance(const Polygon& outline, const GridFrame& frame, const RunContext& run) {
  ScalarField distance = geom::signed_distance({outline}, frame, run);
  for (float& d : distance.cells()) d = -d;
  return distance;
}

}  // namespace

std::vector<double> levels_of(const ContourSet& set) {
  std::vector<double> levels;
  for (const Contour& contour : set.contours) levels.push_back(contour.height_m);
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

double min_gap(const std::vector<double>& levels) {
  double gap = std::numeric_limits<double>::infinity();
  for (size_t i = 1; i < levels.size(); ++i) gap = std::min(gap, levels[i] - levels[i - 1]);
  return std::isfinite(gap) ? gap : 1.0;
}

std::vector<double> levels_covering(std::vector<double> levels, double low, double high, const std::string& name) {
  constexpr double kMost = 10000.0;
  const double below = levels.size() > 1 ? levels[1] - levels[0] : 1.0;
  const double above = levels.size() > 1 ? levels.back() - levels[levels.size() - 2] : 1.0;
  if ((levels.front() - low) / below + (high - levels.back()) / above > kMost)
    throw InvalidArgument(name, "heights from " + format_number(std::round(low)) + " to " +
                                    format_number(std::round(high)) + " m would need more than 10000 levels of " +
                                    format_number(std::min(below, above)) + " m");
  while (levels.back() + above <= high) levels.push_back(levels.back() + above);
  std::vector<double> lower;
  for (double level = levels.front() - below; level > low; level -= below) lower.push_back(level);
  levels.insert(levels.begin(), lower.rbegin(), lower.rend());
  return levels;
}

double height_around(const ContourSet& set, Vec2 place) {
  const std::vector<double> levels = levels_of(set);
  const double gap = min_gap(levels);
  const Contour* around = nullptr;
  for (const Contour& contour : set.contours) {  // parents come first, so the last one found is the innermost
    if (geom::contains(contour.ring, place)) around = &contour;
  }
  if (around == nullptr) return levels.front() - 0.5 * gap;
  return around->height_m + (geom::is_hill(*around) ? 0.25 : -0.25) * gap;
}

double lattice_cell(double extent_m, double mean_edge_m) {
  constexpr double kFinest = 384.0, kCoarsest = 96.0;
  return std::clamp(0.7 * mean_edge_m, extent_m / kFinest, extent_m / kCoarsest);
}

double mean_edge(const ContourSet& set, const std::vector<size_t>& contours) {
  double length = 0.0;
  double edges = 0.0;
  for (const size_t i : contours) {
    length += geom::ring_length(set.contours[i].ring);
    edges += static_cast<double>(set.contours[i].ring.size());
  }
  return edges > 0.0 ? length / edges : 0.0;
}

double surroundings(const Polygon& outline) { return 0.5 * std::sqrt(std::abs(geom::signed_area(outline.outer))); }

EditArea make_edit_area(const ContourSet& set, const Polygon& outline, bool strictly_inside, double margin_m,
                        const std::string& name, const RunContext& run) {
  if (set.contours.empty()) throw InvalidArgument(name, "there are no contours to join to");
  if (const auto defect = geom::find_defect(outline)) throw InvalidArgument(name, *defect);
  check_inside(outline.outer, set.frame, name);
  geom::Box box = geom::bounding_box(outline.outer);
  std::vector<size_t> near;
  for (size_t i = 0; i < set.contours.size(); ++i) {
    const geom::Box own = geom::bounding_box(set.contours[i].ring);
    if (own.low.x <= box.high.x && own.high.x >= box.low.x && own.low.y <= box.high.y && own.high.y >= box.low.y)
      near.push_back(i);
  }
  const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const double cell = lattice_cell(extent, mean_edge(set, near));
  box = {box.low - Vec2{margin_m, margin_m}, box.high + Vec2{margin_m, margin_m}};
  constexpr int kAttempts = 8;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const GridFrame frame = lattice(box, cell, attempt, set.frame.crs);
    ScalarField inward = inward_distance(outline, frame, run);
    Patch patch = patch_of(inward, strictly_inside ? 3.5 * cell : 0.0);
    if (!is_clear(patch, set, run)) continue;
    run.check_cancelled();
    const double without = height_around(set, outline.outer[0]);
    ScalarField heights = lattice_heights(level_lines(set), frame, min_gap(levels_of(set)), without, run);
    return {std::move(patch), std::move(inward), std::move(heights)};
  }
  throw InvalidArgument(name,
                        "contours pass through the lattice's corners however it is laid; move the outline a little");
}

}  // namespace seamount::contour
