// A ring whose edges are sorted into rows, so that asking whether a place lies inside looks at a few of them only.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/model/drawn.h"

namespace seamount::geom {

class RingRows {
 public:
  RingRows() = default;
  /// As many rows as edges, or fewer, so that no more than four entries an edge arise. Linear. REQUIRES: finite.
  explicit RingRows(const Ring& ring);

  /// By the even-odd rule, exactly as contains() of polygon.h answers.
  bool contains(Vec2 p) const;

 private:
  struct Edge {
    Vec2 a, b;
  };
  size_t row_of(double y) const;

  double low_ = 0.0, high_ = -1.0, scale_ = 0.0;
  std::vector<uint32_t> starts_;
  std::vector<Edge> edges_;
};

}  // namespace seamount::geom
