// See edge_grid.h.
#include "seamount/geom/polygon/edge_grid.h"

#include <numeric>

#include "seamount/geom/scalar/segment.h"

namespace seamount::geom {

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
  low_ = edges[0].a;
  Vec2 high = low_;
  for (const RingEdge& edge : edges) {
    low_ = {std::min({low_.x, edge.a.x, edge.b.x}), std::min({low_.y, edge.a.y, edge.b.y})};
    high = {std::max({high.x, edge.a.x, edge.b.x}), std::max({high.y, edge.a.y, edge.b.y})};
  }
  side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(edges.size()))), 1, 2048);
  const double extent = std::max(high.x - low_.x, high.y - low_.y);
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
  if (e.next == second) return turns_back(e.a, e.b, f.b) ? std::optional(e.b) : std::nullopt;
  if (f.next == first) return turns_back(f.a, f.b, e.b) ? std::optional(f.b) : std::nullopt;
  return segments_meet(e.a, e.b, f.a, f.b) ? std::optional(meeting_place(e.a, e.b, f.a, f.b)) : std::nullopt;
}

/// REQUIRES: the edge spans the height of p.
bool EdgeGrid::lies_west_of(Vec2 p, const RingEdge& edge) {
  return orientation_sign(edge.a, edge.b, p) == (edge.a.y < edge.b.y ? 1 : -1);
}

/// Of two edges that do not cross, whether the first lies east of the other at the heights that both span: by the
/// higher of their lower ends or, where that is shared, by the lower of their upper ones.
bool EdgeGrid::lies_east(const RingEdge& edge, const RingEdge& other) {
  const auto [low, high] = std::minmax(edge.a, edge.b, [](Vec2 a, Vec2 b) { return a.y < b.y; });
  const auto [other_low, other_high] = std::minmax(other.a, other.b, [](Vec2 a, Vec2 b) { return a.y < b.y; });
  int west =
      low.y >= other_low.y ? orientation_sign(other_low, other_high, low) : -orientation_sign(low, high, other_low);
  if (west == 0) {
    west = high.y <= other_high.y ? orientation_sign(other_low, other_high, high)
                                  : -orientation_sign(low, high, other_high);
  }
  return west < 0;
}

double EdgeGrid::x_at(const RingEdge& edge, double y) {
  return edge.a.x + (y - edge.a.y) / (edge.b.y - edge.a.y) * (edge.b.x - edge.a.x);
}

/// Row by row the cells that the part of the edge within the row passes, and those within kSlack of it.
template <class Visit>
void EdgeGrid::for_each_cell(const RingEdge& edge, Visit&& visit) const {
  const Vec2 a = edge.a.y <= edge.b.y ? edge.a - low_ : edge.b - low_;
  const Vec2 b = edge.a.y <= edge.b.y ? edge.b - low_ : edge.a - low_;
  const double slack = kSlack / scale_;
  const int last = cell_of(b.y + slack);
  for (int row = cell_of(a.y - slack); row <= last; ++row) {
    const auto x_at_row = [&](double y) {
      return b.y > a.y ? a.x + (b.x - a.x) * std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0) : a.x;
    };
    double from = x_at_row(row / scale_ - slack);
    double to = b.y > a.y ? x_at_row((row + 1) / scale_ + slack) : b.x;
    if (from > to) std::swap(from, to);
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
      nearest = std::min(nearest, squared_distance_to_segment(p, edge.a, edge.b));
    }
  }
  return std::sqrt(nearest);
}

}  // namespace seamount::geom
