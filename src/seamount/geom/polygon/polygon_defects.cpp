// Crossings and defects (polygon.h), among the edges that share a cell of a grid (edge_grid.h).
#include <algorithm>
#include <cmath>

#include "seamount/base/text.h"
#include "seamount/geom/polygon/edge_grid.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::geom {
namespace {

std::string ring_name(size_t ring) {
  return ring == 0 ? std::string("outer ring") : "hole " + std::to_string(ring - 1);
}

std::optional<std::string> ring_defect(const Ring& ring, size_t number) {
  const std::string name = ring_name(number);
  if (ring.size() < 3) return name + " has " + std::to_string(ring.size()) + " points; it needs at least 3";
  for (size_t i = 0; i < ring.size(); ++i) {
    if (!std::isfinite(ring[i].x) || !std::isfinite(ring[i].y)) {
      return name + ": point " + std::to_string(i) + " " + format_place(ring[i]) + " is not finite";
    }
  }
  const Box box = bounding_box(ring);
  const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  // Longer flat rings run back over themselves, which the search for meetings reports with its place.
  const bool flat = ring.size() == 3 && std::abs(signed_area(ring)) <= 1e-14 * extent * extent;
  if (extent == 0.0 || flat) return name + " encloses no area";
  return std::nullopt;
}

/// Whether q lies on the segment from a to b.
bool lies_on(Vec2 q, Vec2 a, Vec2 b) {
  return orientation_sign(a, b, q) == 0 && std::min(a.x, b.x) <= q.x && q.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= q.y && q.y <= std::max(a.y, b.y);
}

/// The two ways on from a place that lies on an edge: to its ends, or past the corner that it is.
struct Ways {
  Vec2 back, on;
};
Ways ways_from(Vec2 place, size_t edge, const std::vector<RingEdge>& edges, const std::vector<size_t>& previous) {
  const RingEdge& e = edges[edge];
  if (place == e.a) return {edges[previous[edge]].a, e.b};
  if (place == e.b) return {e.a, edges[e.next].b};
  return {e.a, e.b};
}

/// Whether two directions from a place are the same.
bool same_direction(Vec2 place, Vec2 to, Vec2 other) {
  const Vec2 a = to - place, b = other - place;
  return orientation_sign(place, to, other) == 0 && (a.x * b.x > 0.0 || a.y * b.y > 0.0);
}

/// Whether, turning counter-clockwise about a place from `from` to `till`, one passes `to`. REQUIRES: three directions.
bool between(Vec2 place, Vec2 from, Vec2 to, Vec2 till) {
  const bool left = orientation_sign(place, from, to) > 0;
  const bool right = orientation_sign(place, to, till) > 0;
  return orientation_sign(place, from, till) > 0 ? left && right : left || right;
}

/// Whether two rings that meet at a place only touch there, neither crossing nor running along each other.
bool only_touch(Vec2 place, const Ways& one, const Ways& other) {
  for (const Vec2 a : {one.back, one.on})
    for (const Vec2 b : {other.back, other.on})
      if (same_direction(place, a, b)) return false;
  return between(place, one.back, other.back, one.on) == between(place, one.back, other.on, one.on);
}

/// The place where two edges touch, an end of one of them on the other; nothing where they cross.
std::optional<Vec2> touch_of(const RingEdge& e, const RingEdge& f) {
  for (const Vec2 end : {e.a, e.b})
    if (lies_on(end, f.a, f.b)) return end;
  for (const Vec2 end : {f.a, f.b})
    if (lies_on(end, e.a, e.b)) return end;
  return std::nullopt;
}

/// The first pair of edges that make a polygon unsound. Two rings may touch in single places.
std::optional<EdgeGrid::Meeting> find_bad_meeting(const std::vector<RingEdge>& edges) {
  std::vector<size_t> previous(edges.size());
  for (size_t i = 0; i < edges.size(); ++i) previous[edges[i].next] = i;
  std::optional<EdgeGrid::Meeting> bad;
  const EdgeGrid grid(edges);
  grid.for_each_meeting([](const RingEdge&, const RingEdge&) { return true; },
                        [&](const EdgeGrid::Meeting& meeting) {
                          const RingEdge& e = edges[meeting.first];
                          const RingEdge& f = edges[meeting.second];
                          const auto place = e.ring != f.ring ? touch_of(e, f) : std::nullopt;
                          if (place && only_touch(*place, ways_from(*place, meeting.first, edges, previous),
                                                  ways_from(*place, meeting.second, edges, previous)))
                            return true;
                          bad = meeting;
                          return false;
                        });
  return bad;
}

/// Whether a hole lies inside. REQUIRES: it crosses no edge of the ring, but may touch it.
bool lies_inside(const Ring& hole, const Ring& outer) {
  const auto on_outer = [&](Vec2 p) {
    for (size_t i = 0; i < outer.size(); ++i)
      if (lies_on(p, outer[i], outer[(i + 1) % outer.size()])) return true;
    return false;
  };
  for (const Vec2 p : hole)
    if (!on_outer(p)) return contains(outer, p);
  return contains(outer, 0.5 * (hole[0] + hole[1]));
}

std::string describe(const RingEdge& e) { return "edge " + std::to_string(e.index) + " of the " + ring_name(e.ring); }

}  // namespace

std::string format_place(Vec2 p) {
  // To the millimetre: what lies below it is rounding.
  const auto metres = [](double v) { return format_number(std::round(v * 1000.0) / 1000.0 + 0.0); };
  return "(" + metres(p.x) + ", " + metres(p.y) + ")";
}

std::optional<std::string> find_defect(const Polygon& polygon) {
  std::vector<RingEdge> edges;
  for (size_t r = 0; r <= polygon.holes.size(); ++r) {
    const Ring& ring = r == 0 ? polygon.outer : polygon.holes[r - 1];
    if (std::optional<std::string> defect = ring_defect(ring, r)) return defect;
    add_ring_edges(ring, r, edges);
  }
  if (const auto meeting = find_bad_meeting(edges)) {
    return describe(edges[meeting->first]) + " and " + describe(edges[meeting->second]) + " cross or touch at " +
           format_place(meeting->at);
  }
  for (size_t h = 0; h < polygon.holes.size(); ++h) {
    if (!lies_inside(polygon.holes[h], polygon.outer))
      return "hole " + std::to_string(h) + " lies outside the outer ring";
  }
  return std::nullopt;
}

std::optional<Vec2> find_crossing(const Ring& a, const Ring& b) {
  std::vector<RingEdge> edges;
  add_ring_edges(a, 0, edges);
  add_ring_edges(b, 1, edges);
  if (edges.empty()) return std::nullopt;
  const EdgeGrid grid(edges);
  const auto meeting = grid.find_meeting([](const RingEdge& e, const RingEdge& f) { return e.ring != f.ring; });
  if (!meeting) return std::nullopt;
  return meeting->at;
}

}  // namespace seamount::geom
