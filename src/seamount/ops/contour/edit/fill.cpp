#include "seamount/ops/contour/edit/fill.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/solve/poisson.h"
#include "seamount/ops/contour/edit/edit_area.h"
#include "seamount/ops/contour/edit/selection.h"
#include "seamount/ops/contour/move/roughen.h"

namespace seamount::contour {
namespace {

/// A distribution of heights: the share of area at or above a height, as a function that falls from 1 to 0.
class Hypsometry {
 public:
  /// Points (height, area at or above), heights ascending.
  explicit Hypsometry(std::vector<Knot> points) : points_(std::move(points)) {}
  /// The height that a share of the area lies above.
  double height(double share) const {
    const double area = share * points_.front().y;
    size_t i = 1;
    while (i + 1 < points_.size() && points_[i].y > area) ++i;
    const Knot& a = points_[i - 1];
    const Knot& b = points_[i];
    const double t = a.y > b.y ? std::clamp((a.y - area) / (a.y - b.y), 0.0, 1.0) : 0.0;
    return a.x + t * (b.x - a.x);
  }

 private:
  std::vector<Knot> points_;
};

/// Marks the contour and what lies inside it.
std::vector<char> family(const ContourSet& set, size_t contour) {
  std::vector<char> inside(set.contours.size(), 0);
  inside[contour] = 1;
  for (size_t i = contour + 1; i < inside.size(); ++i) {
    const int parent = set.contours[i].parent;
    if (parent >= 0 && inside[static_cast<size_t>(parent)] != 0) inside[i] = 1;
  }
  return inside;
}

/// Heights away from the outline's own, in its direction (up in a hill), and the area that lies beyond each.
Hypsometry hypsometry(const ContourSet& set, const std::vector<size_t>& roots) {
  const bool hill = geom::is_hill(set.contours[roots[0]]);
  const double base = set.contours[roots[0]].height_m;
  std::vector<Knot> areas;
  for (const size_t root : roots) {
    const std::vector<char> inside = family(set, root);
    for (size_t i = root; i < inside.size(); ++i) {
      if (inside[i] == 0) continue;
      const double rise = (set.contours[i].height_m - base) * (hill ? 1.0 : -1.0);
      const double area = std::abs(geom::signed_area(set.contours[i].ring));
      areas.push_back({rise, geom::is_hill(set.contours[i]) == hill ? area : -area});
    }
  }
  std::sort(areas.begin(), areas.end(),
            [](const Knot& a, const Knot& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Knot> points;
  for (const Knot& area : areas) {
    if (area.x < 0.0) continue;
    if (!points.empty() && points.back().x == area.x) {
      points.back().y += area.y;
    } else {
      points.push_back(area);
    }
  }
  for (size_t i = 1; i < points.size(); ++i) points[i].y = std::clamp(points[i].y, 0.0, points[i - 1].y);
  const double gap = points.size() > 1 ? points.back().x - points[points.size() - 2].x : 1.0;
  points.push_back({points.back().x + 0.7 * gap, 0.0});
  return Hypsometry(std::move(points));
}

bool encloses_any(const ContourSet& set, size_t contour) {
  return std::any_of(set.contours.begin() + static_cast<ptrdiff_t>(contour), set.contours.end(),
                     [&](const Contour& c) { return c.parent == static_cast<int>(contour); });
}

/// Contours like the one to fill, the nearest first, until their areas are twice its own.
std::vector<size_t> models_for(const ContourSet& set, size_t filled) {
  const Contour& own = set.contours[filled];
  const bool hill = geom::is_hill(own);
  const auto middle = [](const Ring& ring) {
    const geom::Box box = geom::bounding_box(ring);
    return 0.5 * (box.low + box.high);
  };
  const Vec2 here = middle(own.ring);
  std::vector<std::pair<double, size_t>> found;
  for (size_t i = 0; i < set.contours.size(); ++i) {
    const Contour& other = set.contours[i];
    if (i == filled || other.height_m != own.height_m || geom::is_hill(other) != hill || !encloses_any(set, i))
      continue;
    const Vec2 off = middle(other.ring) - here;
    found.emplace_back(dot(off, off), i);
  }
  std::sort(found.begin(), found.end());
  std::vector<size_t> models;
  double area = 0.0;
  for (const auto& [distance, i] : found) {
    if (area > 2.0 * std::abs(geom::signed_area(own.ring))) break;
    area += std::abs(geom::signed_area(set.contours[i].ring));
    models.push_back(i);
  }
  if (models.empty() && encloses_any(set, filled)) models.push_back(filled);
  return models;
}

constexpr std::array<std::array<int, 2>, 4> kNeighbours = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// Is the node of the patch and no corner of its border?
bool is_inner(const Patch& patch, int x, int y) {
  return patch.has(x - 1, y - 1) && patch.has(x, y - 1) && patch.has(x - 1, y) && patch.has(x, y);
}

/// Time at which a front from the patch's border arrives at each inner node, with this speed there: |grad T| speed = 1,
/// by fast marching (Sethian 1996). Every node has a neighbour that is reached before it. `order` gets the inner nodes
/// in the order of their arrival.
class Front {
 public:
  Front(const Patch& patch, const ScalarField& speed) : patch_(patch), speed_(speed), time_(patch.nodes, kNever) {
    for (int y = 0; y < patch.nodes.height; ++y) {
      for (int x = 0; x < patch.nodes.width; ++x) {
        if (patch.at_border(x, y)) time_(x, y) = 0.0;
      }
    }
  }

  std::vector<int32_t> run(const RunContext& run) {
    for (int y = 0; y < patch_.nodes.height; ++y) {
      for (int x = 0; x < patch_.nodes.width; ++x) {
        if (patch_.at_border(x, y)) push_neighbours(x, y);
      }
    }
    std::vector<int32_t> order;
    while (!open_.empty()) {
      const auto [time, at] = open_.top();
      open_.pop();
      const int x = at % patch_.nodes.width;
      const int y = at / patch_.nodes.width;
      if (time_(x, y) != kNever) continue;
      time_(x, y) = time;
      order.push_back(at);
      if (order.size() % 65536 == 0) run.check_cancelled();
      push_neighbours(x, y);
    }
    return order;
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  void push_neighbours(int x, int y) {
    for (const auto& step : kNeighbours) {
      const int nx = x + step[0];
      const int ny = y + step[1];
      if (!time_.contains(nx, ny) || time_(nx, ny) != kNever || !is_inner(patch_, nx, ny)) continue;
      open_.emplace(arrival(nx, ny), ny * patch_.nodes.width + nx);
    }
  }

  double known(int x, int y) const { return time_.contains(x, y) ? time_(x, y) : kNever; }

  double arrival(int x, int y) const {
    const double a = std::min(known(x - 1, y), known(x + 1, y));
    const double b = std::min(known(x, y - 1), known(x, y + 1));
    const double step = 1.0 / static_cast<double>(speed_(x, y));
    if (std::abs(a - b) >= step) return std::min(a, b) + step;
    return 0.5 * (a + b + std::sqrt(2.0 * step * step - (a - b) * (a - b)));
  }

  const Patch& patch_;
  const ScalarField& speed_;
  Grid<double> time_;
  using Open = std::pair<double, int32_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

/// The inside of a contour.
void fill_contour(size_t contour, const FillTool& tool, ContourSet& set, const std::string& name, Seed seed,
                  const RunContext& run) {
  const std::vector<size_t> models = models_for(set, contour);
  if (models.empty())
    throw InvalidArgument(name, "no contour of " + format_number(set.contours[contour].height_m) +
                                    " m encloses others, this one neither: there is nothing to be like");
  const Hypsometry distribution = hypsometry(set, models);
  const double sign = geom::is_hill(set.contours[contour]) ? 1.0 : -1.0;
  const double base = set.contours[contour].height_m;
  std::vector<double> levels = levels_of(set);
  std::vector<char> gone = family(set, contour);
  gone[contour] = 0;
  const Polygon outline{set.contours[contour].ring, {}};
  remove_contours(set, gone);
  const EditArea area = make_edit_area(set, outline, true, 0.0, name, run);
  const GridFrame& frame = area.patch.nodes;
  constexpr float kContrast = 2.5F;  // of the logarithm of the speed over the noise
  ScalarField speed = geom::fbm_grid(frame, seed.derive("fill"), landforms(tool.wavelength_m, frame.cell_m), run);
  for (float& value : speed.cells()) value = std::exp(kContrast * value);
  const std::vector<int32_t> order = Front(area.patch, speed).run(run);
  ScalarField heights = area.ground;
  const double border = std::abs(static_cast<double>(min_gap(levels))) * 0.02;
  double top = base;
  for (size_t i = 0; i < order.size(); ++i) {
    const double share = 1.0 - (static_cast<double>(i) + 0.5) / static_cast<double>(order.size());
    const double height = base + sign * (border + tool.relief * distribution.height(share));
    heights.cells()[static_cast<size_t>(order[i])] = static_cast<float>(height);
    top = sign * height > sign * top ? height : top;
  }
  levels = levels_covering(levels, std::min(base, top), std::max(base, top), name);
  replace_patch(set, area.patch, heights, levels, name, run);
}

}  // namespace

void fill_outline(const Outline& outline, const FillTool& tool, const std::vector<LibraryPattern>& library,
                  ContourSet& set, const std::string& name, Seed seed, const RunContext& run) {
  if (outline.contour >= 0) {
    fill_contour(static_cast<size_t>(outline.contour), tool, set, name, seed, run);
  } else {
    fill_polygon(outline.polygon, tool, library, set, name, seed, run);
  }
}

}  // namespace seamount::contour
