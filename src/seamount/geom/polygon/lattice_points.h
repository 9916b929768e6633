// Places on a fine integer lattice, for geometry that must not err: on it the signs of areas and of the in-circle
// determinant are exact in 128 bits, so algorithms built on them need no tolerance and give the same bytes everywhere.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"

namespace seamount::geom {

/// Coordinates of lattice points lie in [0, 2^29).
inline constexpr int kLatticeBits = 29;
inline constexpr int32_t kLatticeEnd = int32_t{1} << kLatticeBits;

struct LatticePoint {
  int32_t x = 0;
  int32_t y = 0;
  auto operator<=>(const LatticePoint&) const = default;
};

/// Where a lattice lies.
struct Lattice {
  Vec2 origin;          ///< of lattice point (0, 0), metres
  double unit_m = 1.0;  ///< distance of neighbours, > 0

  Vec2 place(LatticePoint p) const { return {origin.x + unit_m * p.x, origin.y + unit_m * p.y}; }
};

/// Twice the area of the triangle (a, b, c): positive if it runs counter-clockwise, 0 on a line. Exact.
inline int64_t orientation(LatticePoint a, LatticePoint b, LatticePoint c) {
  return (int64_t{b.x} - a.x) * (int64_t{c.y} - a.y) - (int64_t{b.y} - a.y) * (int64_t{c.x} - a.x);
}

/// Squared distance. Exact.
inline int64_t squared_distance(LatticePoint a, LatticePoint b) {
  const int64_t dx = int64_t{b.x} - a.x;
  const int64_t dy = int64_t{b.y} - a.y;
  return dx * dx + dy * dy;
}

/// Does p lie strictly inside the circle through the counter-clockwise triangle (a, b, c)? Exact for coordinates in
/// [0, 2^kBits): factors below 2^(2 kBits + 3), products below 2^(4 kBits + 6), in 64 bits up to 14, which is faster.
template <int kBits = kLatticeBits>
bool in_circle(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint p) {
  __extension__ using Int128 = __int128;
  using Wide = std::conditional_t<kBits <= 14, int64_t, Int128>;
  const int64_t ax = int64_t{a.x} - p.x, ay = int64_t{a.y} - p.y;
  const int64_t bx = int64_t{b.x} - p.x, by = int64_t{b.y} - p.y;
  const int64_t cx = int64_t{c.x} - p.x, cy = int64_t{c.y} - p.y;
  const Wide det = static_cast<Wide>(ax * ax + ay * ay) * (bx * cy - by * cx) +
                   static_cast<Wide>(bx * bx + by * by) * (cx * ay - cy * ax) +
                   static_cast<Wide>(cx * cx + cy * cy) * (ax * by - ay * bx);
  return det > 0;
}

/// The finest lattice over some points, and the nearest lattice point of each. REQUIRES: finite coordinates.
Lattice snap(std::span<const Vec2> points, std::vector<LatticePoint>& snapped);

/// Indices of the points along a Hilbert curve over their bounding square: neighbours in the order are neighbours in
/// the plane. Points in one cell of the curve (65536 to a side) stay in their order. Linear time.
std::vector<int32_t> spatial_order(std::span<const LatticePoint> points, const RunContext& run = {});

}  // namespace seamount::geom
