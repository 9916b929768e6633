// Marching squares (marching_squares.h) as areas and lines.
#include "seamount/geom/contour/contour.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "seamount/geom/contour/marching_squares.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::geom {
namespace {

/// Drops repeated points and points in the middle of a straight run along an axis (the frame's edge).
Ring tidy(const Polyline& points) {
  Ring ring;
  const auto between = [](Vec2 a, Vec2 b, Vec2 c) { return (a.x == b.x && b.x == c.x) || (a.y == b.y && b.y == c.y); };
  for (const Vec2 p : points) {
    if (!ring.empty() && ring.back() == p) continue;
    if (ring.size() > 1 && between(ring[ring.size() - 2], ring.back(), p)) ring.pop_back();
    ring.push_back(p);
  }
  while (ring.size() > 2 &&
         (ring.back() == ring.front() || between(ring[ring.size() - 2], ring.back(), ring.front()))) {
    ring.pop_back();
  }
  if (ring.size() > 2 && between(ring.back(), ring[0], ring[1])) ring.erase(ring.begin());
  return ring;
}

/// Sorts closed rings into polygons: a clockwise ring is a hole of the smallest ring around it.
std::vector<Polygon> nest(std::vector<Ring> rings, const RunContext& run) {
  std::vector<Polygon> polygons;
  std::vector<double> areas;
  std::vector<Box> boxes;
  for (Ring& ring : rings) {
    const double size = signed_area(ring);
    if (size <= 0.0) continue;
    areas.push_back(size);
    boxes.push_back(bounding_box(ring));
    polygons.push_back({std::move(ring), {}});
    ring.clear();
  }
  for (Ring& ring : rings) {
    if (ring.size() < 3) continue;
    run.check_cancelled();
    const Vec2 p = ring.front();
    size_t best = polygons.size();
    for (size_t i = 0; i < polygons.size(); ++i) {
      const Box& box = boxes[i];
      const bool boxed = p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
      if (!boxed || (best < polygons.size() && areas[i] >= areas[best])) continue;
      if (contains(polygons[i].outer, p)) best = i;
    }
    if (best < polygons.size()) polygons[best].holes.push_back(std::move(ring));
  }
  return polygons;
}

/// Taubin's smoothing (1995: shrink, then swell, so the size stays) with every point kept within `reach` of where it
/// was, and points on the frame's edge left there.
Ring smooth_steps(const Ring& ring, double reach, const GridFrame& frame, const RunContext& run) {
  constexpr int kRounds = 12;
  const size_t n = ring.size();
  if (n < 4) return ring;
  Ring now = ring;
  Ring next(n);
  for (int half = 0; half < 2 * kRounds; ++half) {
    run.check_cancelled();
    const double share = half % 2 == 0 ? 0.5 : -0.53;
    for (size_t i = 0; i < n; ++i) {
      const Vec2 middle = 0.5 * (now[(i + n - 1) % n] + now[(i + 1) % n]);
      next[i] = now[i] + share * (middle - now[i]);
      const Vec2 moved = next[i] - ring[i];
      const double distance = std::hypot(moved.x, moved.y);
      if (distance > reach) next[i] = ring[i] + (reach / distance) * moved;
      const bool pinned = ring[i].x <= frame.west_m || ring[i].x >= frame.east_m() || ring[i].y >= frame.north_m ||
                          ring[i].y <= frame.south_m();
      if (pinned) next[i] = ring[i];
    }
    std::swap(now, next);
  }
  return now;
}

}  // namespace

std::vector<Polygon> trace_areas(const ScalarField& field, double level, const RunContext& run) {
  std::vector<Ring> rings;
  const double levels[] = {static_cast<float>(level)};
  for (const ContourChain& chain : march_squares(field, levels, FieldEdge::closed, run)) {
    run.check_cancelled();
    Ring ring = tidy(chain.points);
    if (ring.size() >= 3) rings.push_back(std::move(ring));
  }
  return nest(std::move(rings), run);
}

std::vector<Polyline> trace_lines(const ScalarField& field, double level, const RunContext& run) {
  std::vector<Polyline> lines;
  const double levels[] = {static_cast<float>(level)};
  for (ContourChain& chain : march_squares(field, levels, FieldEdge::open, run)) {
    if (chain.closed) chain.points.push_back(chain.points.front());
    lines.push_back(std::move(chain.points));
  }
  return lines;
}

std::vector<Contour> trace_contours(const ScalarField& field, std::span<const double> levels, const RunContext& run) {
  std::vector<Contour> contours;
  for (ContourChain& chain : march_squares(field, levels, FieldEdge::apron, run)) {
    contours.push_back({levels[chain.level], std::move(chain.points), -1});
  }
  return contours;
}

std::vector<Polygon> trace_mask(const Grid<uint8_t>& inside, const RunContext& run) {
  ScalarField field(inside.frame());
  std::transform(inside.cells().begin(), inside.cells().end(), field.cells().begin(),
                 [](uint8_t in) { return in != 0 ? 1.0F : 0.0F; });
  std::vector<Polygon> polygons = trace_areas(field, 0.5, run);
  const double reach = 0.45 * inside.cell_m();
  for (Polygon& polygon : polygons) {
    polygon.outer = smooth_steps(polygon.outer, reach, inside.frame(), run);
    for (Ring& hole : polygon.holes) hole = smooth_steps(hole, reach, inside.frame(), run);
  }
  return polygons;
}

}  // namespace seamount::geom
