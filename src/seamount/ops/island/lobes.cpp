#include "seamount/ops/island/lobes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::island {
namespace {

constexpr size_t kMostLobes = 48;
constexpr double kLeast = 0.125;  // of the largest radius of its polygon

/// Around a polygon's outer ring, with `side` nodes along the longer side.
GridFrame frame_over(const Polygon& polygon, int side) {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
  for (const Vec2 p : polygon.outer) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  GridFrame frame;
  frame.cell_m = std::max(1e-6, std::max(high.x - low.x, high.y - low.y) / side);
  frame.width = std::clamp(static_cast<int>(std::ceil((high.x - low.x) / frame.cell_m)), 1, side);
  frame.height = std::clamp(static_cast<int>(std::ceil((high.y - low.y) / frame.cell_m)), 1, side);
  frame.west_m = low.x;
  frame.north_m = high.y;
  return frame;
}

bool larger(const Lobe& a, const Lobe& b) { return a.radius_m > b.radius_m; }

/// Those of `sorted` that do not overlap one before them, above a least radius.
std::vector<Lobe> those_apart(const std::vector<Lobe>& sorted, double least) {
  std::vector<Lobe> lobes;
  for (const Lobe& lobe : sorted) {
    if (lobes.size() == kMostLobes || (!lobes.empty() && lobe.radius_m < least * lobes.front().radius_m)) break;
    const bool apart = std::all_of(lobes.begin(), lobes.end(), [&](const Lobe& other) {
      return std::hypot(lobe.centre.x - other.centre.x, lobe.centre.y - other.centre.y) >=
             lobe.radius_m + other.radius_m;
    });
    if (apart) lobes.push_back(lobe);
  }
  return lobes;
}

std::vector<Lobe> lobes_of(const Polygon& polygon, int side, const RunContext& run) {
  const ScalarField distance = geom::signed_distance({polygon}, frame_over(polygon, side), run);
  const GridFrame& frame = distance.frame();
  std::vector<Lobe> nodes;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      if (distance(x, y) < 0.0F) nodes.push_back({{frame.x(x), frame.y(y)}, -static_cast<double>(distance(x, y))});
    }
  }
  std::stable_sort(nodes.begin(), nodes.end(), larger);
  return those_apart(nodes, kLeast);
}

}  // namespace

double natural_height(double width_m) {
  const double side_km = 0.5 * std::sqrt(std::numbers::pi) * width_m / 1000.0;  // of a square as large as the disc
  return std::min(4200.0, 110.0 * std::pow(side_km, 0.78));
}

std::vector<Lobe> find_lobes(const std::vector<Polygon>& land, const RunContext& run) {
  double all_m2 = 0.0;
  for (const Polygon& polygon : land) all_m2 += geom::area(polygon);
  std::vector<Lobe> found;
  for (const Polygon& polygon : land) {
    const double share = std::sqrt(geom::area(polygon) / std::max(all_m2, 1e-12));
    const std::vector<Lobe> own = lobes_of(polygon, std::clamp(static_cast<int>(160.0 * share), 12, 144), run);
    found.insert(found.end(), own.begin(), own.end());
  }
  std::stable_sort(found.begin(), found.end(), larger);
  return those_apart(found, 0.0);
}

}  // namespace seamount::island
