// See ring_rows.h.
#include "seamount/geom/skeleton/ring_rows.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "seamount/geom/polygon/predicates.h"

namespace seamount::geom {

size_t RingRows::row_of(double y) const {
  return static_cast<size_t>(std::clamp((y - low_) * scale_, 0.0, static_cast<double>(starts_.size()) - 2.0));
}

RingRows::RingRows(const Ring& ring) {
  if (ring.size() < 3) return;
  const auto [lowest, highest] =
      std::minmax_element(ring.begin(), ring.end(), [](Vec2 a, Vec2 b) { return a.y < b.y; });
  low_ = lowest->y;
  high_ = highest->y;
  const auto rows_of_edge = [&](size_t i) {
    return std::minmax({row_of(ring[i].y), row_of(ring[(i + 1) % ring.size()].y)});
  };
  for (size_t rows = ring.size();; rows /= 2) {
    starts_.assign(rows + 1, 0);
    scale_ = high_ > low_ ? static_cast<double>(rows) / (high_ - low_) : 0.0;
    size_t entries = 0;
    for (size_t i = 0; i < ring.size(); ++i) {
      const auto [from, to] = rows_of_edge(i);
      entries += to - from + 1;
    }
    if (rows == 1 || entries <= 4 * ring.size()) break;
  }
  for (size_t i = 0; i < ring.size(); ++i) {
    const auto [from, to] = rows_of_edge(i);
    for (size_t row = from; row <= to; ++row) ++starts_[row + 1];
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  edges_.resize(starts_.back());
  std::vector<uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (size_t i = 0; i < ring.size(); ++i) {
    const auto [from, to] = rows_of_edge(i);
    for (size_t row = from; row <= to; ++row) edges_[next[row]++] = {ring[i], ring[(i + 1) % ring.size()]};
  }
}

bool RingRows::contains(Vec2 p) const {
  if (!(p.y >= low_ && p.y <= high_)) return false;
  const size_t row = row_of(p.y);
  bool inside = false;
  for (uint32_t i = starts_[row]; i < starts_[row + 1]; ++i) {
    if (ray_crosses(p, edges_[i].a, edges_[i].b)) inside = !inside;
  }
  return inside;
}

}  // namespace seamount::geom
