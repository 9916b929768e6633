// Crossings and defects (polygon.h). Edges are entered into a square grid of about as many cells as edges, and only
// edges that share a cell are tested against each other.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "seamount/base/text.h"
#include "seamount/geom/polygon.h"

namespace seamount::geom {
namespace {

struct Edge {
  Vec2 a, b;
  size_t ring, index;  ///< ring 0 is the outer one; the edge leaves point `index`
  size_t next;         ///< number of the edge after it in its ring
};

struct Meeting {
  size_t first, second;  ///< numbers of edges
  Vec2 at;
};

double orientation(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

bool in_box(Vec2 a, Vec2 b, Vec2 p) {
  return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
         p.y <= std::max(a.y, b.y);
}

/// Where two segments cross or touch.
std::optional<Vec2> segments_meet(const Edge& e, const Edge& f) {
  const double a = orientation(f.a, f.b, e.a);
  const double b = orientation(f.a, f.b, e.b);
  const double c = orientation(e.a, e.b, f.a);
  const double d = orientation(e.a, e.b, f.b);
  if (((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)) && ((c > 0.0 && d < 0.0) || (c < 0.0 && d > 0.0))) {
    return e.a + (a / (a - b)) * (e.b - e.a);
  }
  if (a == 0.0 && in_box(f.a, f.b, e.a)) return e.a;
  if (b == 0.0 && in_box(f.a, f.b, e.b)) return e.b;
  if (c == 0.0 && in_box(e.a, e.b, f.a)) return f.a;
  if (d == 0.0 && in_box(e.a, e.b, f.b)) return f.b;
  return std::nullopt;
}

/// The edge after e: a defect only where it runs back over e.
std::optional<Vec2> runs_back(const Edge& e, const Edge& next) {
  const Vec2 back = e.a - e.b;
  const Vec2 on = next.b - next.a;
  if (cross(back, on) == 0.0 && dot(back, on) > 0.0) return e.b;
  return std::nullopt;
}

void add_edges(const Ring& ring, size_t number, std::vector<Edge>& edges) {
  const size_t first = edges.size();
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i];
    const Vec2 b = ring[(i + 1) % ring.size()];
    if (!(a == b)) edges.push_back({a, b, number, i, edges.size() + 1});
  }
  if (edges.size() > first) edges.back().next = first;
}

/// Edges by the cells of a square grid that they pass.
class EdgeGrid {
 public:
  explicit EdgeGrid(const std::vector<Edge>& edges) : edges_(edges) {
    Ring ends;
    for (const Edge& edge : edges) ends.push_back(edge.a);
    const Box box = bounding_box(ends);
    low_ = box.low;
    side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(edges.size()))), 1, 2048);
    const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    scale_ = extent > 0.0 ? side_ / extent : 1.0;
    starts_.assign(static_cast<size_t>(side_) * static_cast<size_t>(side_) + 1, 0);
    for (const Edge& edge : edges) for_each_cell(edge, [&](size_t cell) { ++starts_[cell + 1]; });
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    members_.resize(starts_.back());
    std::vector<size_t> next(starts_.begin(), starts_.end() - 1);
    for (size_t i = 0; i < edges.size(); ++i) for_each_cell(edges[i], [&](size_t cell) { members_[next[cell]++] = i; });
  }

  /// The first pair of edges that meet, of those wanted(edge, edge) allows.
  template <class Wanted>
  std::optional<Meeting> find_meeting(Wanted&& wanted) const {
    for (size_t cell = 0; cell + 1 < starts_.size(); ++cell) {
      for (size_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
        for (size_t j = i + 1; j < starts_[cell + 1]; ++j) {
          const size_t first = members_[i];
          const size_t second = members_[j];
          if (!wanted(edges_[first], edges_[second])) continue;
          if (const std::optional<Vec2> at = test(first, second)) return Meeting{first, second, *at};
        }
      }
    }
    return std::nullopt;
  }

 private:
  std::optional<Vec2> test(size_t first, size_t second) const {
    const Edge& e = edges_[first];
    const Edge& f = edges_[second];
    if (e.next == second) return runs_back(e, f);
    if (f.next == first) return runs_back(f, e);
    return segments_meet(e, f);
  }

  int cell_of(double offset) const { return std::clamp(static_cast<int>(offset * scale_), 0, side_ - 1); }

  /// Row by row the cells that the part of the edge within the row passes, one more on either side against rounding.
  template <class Visit>
  void for_each_cell(const Edge& edge, Visit&& visit) const {
    const Vec2 a = edge.a.y <= edge.b.y ? edge.a - low_ : edge.b - low_;
    const Vec2 b = edge.a.y <= edge.b.y ? edge.b - low_ : edge.a - low_;
    const int last = cell_of(b.y);
    for (int row = cell_of(a.y); row <= last; ++row) {
      const auto x_at = [&](double y) {
        return b.y > a.y ? a.x + (b.x - a.x) * std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0) : a.x;
      };
      double from = x_at(row / scale_);
      double to = b.y > a.y ? x_at((row + 1) / scale_) : b.x;
      if (from > to) std::swap(from, to);
      const double slack = 1e-6 / scale_;
      const int end = cell_of(to + slack);
      for (int column = cell_of(from - slack); column <= end; ++column) {
        visit(static_cast<size_t>(row) * static_cast<size_t>(side_) + static_cast<size_t>(column));
      }
    }
  }

  const std::vector<Edge>& edges_;
  Vec2 low_;
  int side_ = 1;
  double scale_ = 1.0;
  std::vector<size_t> starts_;
  std::vector<size_t> members_;
};

/// To the millimetre: what lies below it is rounding.
std::string place(Vec2 p) {
  const auto metres = [](double v) { return format_number(std::round(v * 1000.0) / 1000.0 + 0.0); };
  return "(" + metres(p.x) + ", " + metres(p.y) + ")";
}

std::string ring_name(size_t ring) {
  return ring == 0 ? std::string("outer ring") : "hole " + std::to_string(ring - 1);
}

std::optional<std::string> ring_defect(const Ring& ring, size_t number) {
  const std::string name = ring_name(number);
  if (ring.size() < 3) return name + " has " + std::to_string(ring.size()) + " points; it needs at least 3";
  for (size_t i = 0; i < ring.size(); ++i) {
    if (!std::isfinite(ring[i].x) || !std::isfinite(ring[i].y)) {
      return name + ": point " + std::to_string(i) + " " + place(ring[i]) + " is not finite";
    }
  }
  const Box box = bounding_box(ring);
  const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  // Longer flat rings run back over themselves, which the search for meetings reports with its place.
  const bool flat = ring.size() == 3 && std::abs(signed_area(ring)) <= 1e-14 * extent * extent;
  if (extent == 0.0 || flat) return name + " encloses no area";
  return std::nullopt;
}

std::string describe(const Edge& e) { return "edge " + std::to_string(e.index) + " of the " + ring_name(e.ring); }

}  // namespace

std::optional<std::string> find_defect(const Polygon& polygon) {
  std::vector<Edge> edges;
  for (size_t r = 0; r <= polygon.holes.size(); ++r) {
    const Ring& ring = r == 0 ? polygon.outer : polygon.holes[r - 1];
    if (std::optional<std::string> defect = ring_defect(ring, r)) return defect;
    add_edges(ring, r, edges);
  }
  const EdgeGrid grid(edges);
  if (const auto meeting = grid.find_meeting([](const Edge&, const Edge&) { return true; })) {
    return describe(edges[meeting->first]) + " and " + describe(edges[meeting->second]) + " cross or touch at " +
           place(meeting->at);
  }
  for (size_t h = 0; h < polygon.holes.size(); ++h) {
    if (!contains(polygon.outer, polygon.holes[h][0]))
      return "hole " + std::to_string(h) + " lies outside the outer ring";
  }
  return std::nullopt;
}

std::optional<Vec2> find_crossing(const Ring& a, const Ring& b) {
  std::vector<Edge> edges;
  add_edges(a, 0, edges);
  add_edges(b, 1, edges);
  if (edges.empty()) return std::nullopt;
  const EdgeGrid grid(edges);
  const auto meeting = grid.find_meeting([](const Edge& e, const Edge& f) { return e.ring != f.ring; });
  if (!meeting) return std::nullopt;
  return meeting->at;
}

}  // namespace seamount::geom
