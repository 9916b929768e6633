#include "seamount/geom/polygon/polygon.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "seamount/geom/polygon/predicates.h"
#include "seamount/geom/scalar/segment.h"

namespace seamount::geom {
namespace {

double length(Vec2 a) { return std::hypot(a.x, a.y); }

/// Sum over the edges about the first point, so that far coordinates cost no digits.
double twice_area(const Ring& ring) {
  double sum = 0.0;
  for (size_t i = 1; i + 1 < ring.size(); ++i) sum += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return sum;
}

Vec2 centroid(const Ring& ring) {
  const double doubled = twice_area(ring);
  Vec2 sum;
  for (size_t i = 1; i + 1 < ring.size(); ++i) {
    const Vec2 a = ring[i] - ring[0];
    const Vec2 b = ring[i + 1] - ring[0];
    sum = sum + cross(a, b) * (a + b);
  }
  return doubled != 0.0 ? ring[0] + (1.0 / (3.0 * doubled)) * sum : ring[0];
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) { return length(p - nearest_on_segment(p, a, b)); }

/// Marks the points of line[first, last] that Douglas-Peucker keeps, the two ends excepted.
void mark_kept(const Polyline& line, size_t first, size_t last, double tolerance, std::vector<char>& kept) {
  std::vector<std::pair<size_t, size_t>> open = {{first, last}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    double furthest = tolerance;
    size_t at = 0;
    for (size_t i = a + 1; i < b; ++i) {
      const double d = distance_to_segment(line[i], line[a], line[b]);
      if (d > furthest) {
        furthest = d;
        at = i;
      }
    }
    if (at == 0) continue;
    kept[at] = 1;
    open.push_back({a, at});
    open.push_back({at, b});
  }
}

Polyline kept_points(const Polyline& line, const std::vector<char>& kept, size_t count) {
  Polyline result;
  for (size_t i = 0; i < count; ++i) {
    if (kept[i] != 0) result.push_back(line[i]);
  }
  return result;
}

size_t furthest_from(const Ring& ring, Vec2 p) {
  size_t best = 0;
  for (size_t i = 1; i < ring.size(); ++i) {
    if (length(ring[i] - p) > length(ring[best] - p)) best = i;
  }
  return best;
}

/// What lies on the inner side of one side of a box.
template <class Inside>
Ring clip_side(const Ring& ring, Inside&& distance) {
  Ring clipped;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const double da = distance(a), db = distance(b);
    if (da >= 0.0) clipped.push_back(a);
    if ((da >= 0.0) != (db >= 0.0)) clipped.push_back(a + da / (da - db) * (b - a));
  }
  return clipped;
}

}  // namespace

double signed_area(const Ring& ring) { return 0.5 * twice_area(ring); }

double area(const Polygon& polygon) {
  double sum = std::abs(signed_area(polygon.outer));
  for (const Ring& hole : polygon.holes) sum -= std::abs(signed_area(hole));
  return sum;
}

double line_length(const Polyline& line) {
  double sum = 0.0;
  for (size_t i = 1; i < line.size(); ++i) sum += length(line[i] - line[i - 1]);
  return sum;
}

double ring_length(const Ring& ring) {
  return ring.empty() ? 0.0 : line_length(ring) + length(ring.front() - ring.back());
}

double perimeter(const Polygon& polygon) {
  double sum = ring_length(polygon.outer);
  for (const Ring& hole : polygon.holes) sum += ring_length(hole);
  return sum;
}

Box bounding_box(const Ring& ring) {
  if (ring.empty()) return {};
  Box box = {ring[0], ring[0]};
  for (const Vec2 p : ring) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

void orient(Polygon& polygon) {
  if (signed_area(polygon.outer) < 0.0) std::reverse(polygon.outer.begin(), polygon.outer.end());
  for (Ring& hole : polygon.holes) {
    if (signed_area(hole) > 0.0) std::reverse(hole.begin(), hole.end());
  }
}

bool contains(const Ring& ring, Vec2 p) {
  bool inside = false;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i];
    const Vec2 b = ring[i + 1 < ring.size() ? i + 1 : 0];
    if (ray_crosses(p, a, b)) inside = !inside;
  }
  return inside;
}

bool contains(const Polygon& polygon, Vec2 p) {
  if (!contains(polygon.outer, p)) return false;
  return std::none_of(polygon.holes.begin(), polygon.holes.end(), [p](const Ring& hole) { return contains(hole, p); });
}

Polyline simplify_line(const Polyline& line, double tolerance_m) {
  if (line.size() < 3) return line;
  std::vector<char> kept(line.size(), 0);
  kept.front() = kept.back() = 1;
  mark_kept(line, 0, line.size() - 1, tolerance_m, kept);
  return kept_points(line, kept, line.size());
}

Ring simplify(const Ring& ring, double tolerance_m) {
  if (ring.size() < 4) return ring;
  Ring turned = ring;
  std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(furthest_from(ring, ring[0])), turned.end());
  const size_t opposite = furthest_from(turned, turned[0]);
  turned.push_back(turned.front());
  std::vector<char> kept(turned.size(), 0);
  kept[0] = kept[opposite] = 1;
  mark_kept(turned, 0, opposite, tolerance_m, kept);
  mark_kept(turned, opposite, turned.size() - 1, tolerance_m, kept);
  if (std::accumulate(kept.begin(), kept.end(), 0) < 3) {
    size_t widest = opposite == 1 ? 2 : 1;
    for (size_t i = 1; i + 1 < turned.size(); ++i) {
      const double d = i == opposite ? -1.0 : distance_to_segment(turned[i], turned[0], turned[opposite]);
      if (d > distance_to_segment(turned[widest], turned[0], turned[opposite])) widest = i;
    }
    kept[widest] = 1;
  }
  return kept_points(turned, kept, turned.size() - 1);
}

Ring smooth_ring(const Ring& ring, int rounds) {
  if (ring.size() < 4) return ring;
  const size_t n = ring.size();
  Ring now = ring;
  Ring next(n);
  for (int round = 0; round < rounds; ++round) {
    for (size_t i = 0; i < n; ++i) {
      next[i] = 0.5 * now[i] + 0.25 * (now[(i + n - 1) % n] + now[(i + 1) % n]);
    }
    std::swap(now, next);
  }
  const double shrunk = signed_area(now);
  const double wanted = signed_area(ring);
  if (shrunk * wanted <= 0.0) return ring;
  const double scale = std::sqrt(wanted / shrunk);
  const Vec2 centre = centroid(now);
  for (Vec2& p : now) p = centre + scale * (p - centre);
  return now;
}

Ring densify(const Ring& ring, double step_m) {
  Ring dense;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i];
    const Vec2 d = ring[(i + 1) % ring.size()] - a;
    const int parts = std::max(1, static_cast<int>(std::ceil(length(d) / step_m)));
    for (int k = 0; k < parts; ++k) dense.push_back(a + (static_cast<double>(k) / parts) * d);
  }
  return dense;
}

Ring clip_to_box(const Ring& whole, const Box& box) {
  Ring ring = clip_side(whole, [&](Vec2 p) { return p.x - box.low.x; });
  ring = clip_side(ring, [&](Vec2 p) { return box.high.x - p.x; });
  ring = clip_side(ring, [&](Vec2 p) { return p.y - box.low.y; });
  return clip_side(ring, [&](Vec2 p) { return box.high.y - p.y; });
}

}  // namespace seamount::geom
