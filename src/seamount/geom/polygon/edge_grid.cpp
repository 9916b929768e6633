// See edge_grid.h.
#include "seamount/geom/polygon/edge_grid.h"

#include <numeric>

namespace seamount::geom {
namespace {

double orientation(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

bool in_box(Vec2 a, Vec2 b, Vec2 p) {
  return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
         p.y <= std::max(a.y, b.y);
}

/// Where two segments cross or touch.
std::optional<Vec2> segments_meet(const RingEdge& e, const RingEdge& f) {
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
std::optional<Vec2> runs_back(const RingEdge& e, const RingEdge& next) {
  const Vec2 back = e.a - e.b;
  const Vec2 on = next.b - next.a;
  if (cross(back, on) == 0.0 && dot(back, on) > 0.0) return e.b;
  return std::nullopt;
}

}  // namespace

void add_ring_edges(const Ring& ring, size_t number, std::vector<RingEdge>& edges) {
  const size_t first = edges.size();
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i];
    const Vec2 b = ring[(i + 1) % ring.size()];
    if (!(a == b)) edges.push_back({a, b, number, i, edges.size() + 1});
  }
  if (edges.size() > first) edges.back().next = first;
}

EdgeGrid::EdgeGrid(const std::vector<RingEdge>& edges, const RunContext& run) : edges_(edges) {
  if (edges.empty()) return;
  Ring ends;
  ends.reserve(edges.size());
  for (const RingEdge& edge : edges) ends.push_back(edge.a);
  const Box box = bounding_box(ends);
  low_ = box.low;
  side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(edges.size()))), 1, 2048);
  const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  scale_ = extent > 0.0 ? side_ / extent : 1.0;
  starts_.assign(static_cast<size_t>(side_) * static_cast<size_t>(side_) + 1, 0);
  for (const RingEdge& edge : edges) {
    run.check_cancelled();
    for_each_cell(edge, [&](size_t cell) { ++starts_[cell + 1]; });
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  members_.resize(starts_.back());
  std::vector<size_t> next(starts_.begin(), starts_.end() - 1);
  for (size_t i = 0; i < edges.size(); ++i) {
    run.check_cancelled();
    for_each_cell(edges[i], [&](size_t cell) { members_[next[cell]++] = i; });
  }
}

std::optional<Vec2> EdgeGrid::meet(size_t first, size_t second) const {
  const RingEdge& e = edges_[first];
  const RingEdge& f = edges_[second];
  if (e.next == second) return runs_back(e, f);
  if (f.next == first) return runs_back(f, e);
  return segments_meet(e, f);
}

/// Row by row the cells that the part of the edge within the row passes, one more on either side against rounding.
template <class Visit>
void EdgeGrid::for_each_cell(const RingEdge& edge, Visit&& visit) const {
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

double EdgeGrid::distance(Vec2 p, double most) const {
  double nearest = most * most;
  if (members_.empty()) return most;
  const int left = cell_of(p.x - most - low_.x), right = cell_of(p.x + most - low_.x);
  for (int y = cell_of(p.y - most - low_.y); y <= cell_of(p.y + most - low_.y); ++y) {
    const size_t row = static_cast<size_t>(y) * static_cast<size_t>(side_);
    for (size_t i = starts_[row + static_cast<size_t>(left)]; i < starts_[row + static_cast<size_t>(right) + 1]; ++i) {
      const RingEdge& edge = edges_[members_[i]];
      const Vec2 d = edge.b - edge.a;
      const double t = std::clamp(dot(p - edge.a, d) / dot(d, d), 0.0, 1.0);
      const Vec2 away = p - (edge.a + t * d);
      nearest = std::min(nearest, dot(away, away));
    }
  }
  return std::sqrt(nearest);
}

}  // namespace seamount::geom
