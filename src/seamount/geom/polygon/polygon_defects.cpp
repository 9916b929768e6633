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
  const EdgeGrid grid(edges);
  if (const auto meeting = grid.find_meeting([](const RingEdge&, const RingEdge&) { return true; })) {
    return describe(edges[meeting->first]) + " and " + describe(edges[meeting->second]) + " cross or touch at " +
           format_place(meeting->at);
  }
  for (size_t h = 0; h < polygon.holes.size(); ++h) {
    if (!contains(polygon.outer, polygon.holes[h][0]))
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
