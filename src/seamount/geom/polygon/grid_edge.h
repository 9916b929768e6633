// Edges in the units of a grid, for exact distances from many cells to a few edges in loops that are vectorised.
#pragma once

#include "seamount/base/simd.h"

namespace seamount::geom {

/// From (x, y) to (x + dx, y + dy) in cells: x right, y down, cell centres at whole numbers.
template <class T>
struct GridEdge {
  T x, y, dx, dy;
  T inverse;  ///< 1 / (dx^2 + dy^2), 0 for a point
};

template <class T>
SEAMOUNT_INLINE T squared_distance(const GridEdge<T>& edge, T x, T y) {
  const T px = x - edge.x;
  const T py = y - edge.y;
  T t = (px * edge.dx + py * edge.dy) * edge.inverse;
  t = t > T{0} ? (t < T{1} ? t : T{1}) : T{0};
  const T ex = px - t * edge.dx;
  const T ey = py - t * edge.dy;
  return ex * ex + ey * ey;
}

}  // namespace seamount::geom
