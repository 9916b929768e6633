// Decisions about places that must not err: which way three turn, whether two segments meet. The usual formula is
// tried first; where its rounding could matter, the determinant is summed without any (Shewchuk 1997, "Adaptive
// Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates").
//
// Exact for coordinates that are 0 or of a magnitude within [2^-400, 2^400]; beyond, products may over- or underflow.
// For places on an integer lattice see lattice_points.h.
#pragma once

#include <algorithm>
#include <cmath>

#include "seamount/model/drawn.h"

namespace seamount::geom {

/// The same as orientation_sign(), always the long way round; about 50 times slower.
int exact_orientation_sign(Vec2 a, Vec2 b, Vec2 c);

/// 1 if the triangle (a, b, c) runs counter-clockwise (c lies left of the line from a to b), -1 if clockwise, 0 if the
/// three lie on one line. So it keeps its value when they are turned in a circle, and changes sign when two of them are
/// swapped. REQUIRES: finite coordinates.
inline int orientation_sign(Vec2 a, Vec2 b, Vec2 c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double area = left - right;
  // Shewchuk's bound A: (3 + 16 u) u with u = 2^-53. A product of 0 is exact, and so is then the difference.
  constexpr double kBound = 3.3306690738754716e-16;
  const double least = kBound * (std::abs(left) + std::abs(right));
  if (area > least) return 1;
  if (area < -least) return -1;
  return left == 0.0 && right == 0.0 ? 0 : exact_orientation_sign(a, b, c);
}

/// Whether a ray from p due east crosses the edge (a, b), which holds its lower end and not its upper one: a place is
/// inside a ring whose edges it crosses an odd number of times. Exact. REQUIRES: finite coordinates.
inline bool ray_crosses(Vec2 p, Vec2 a, Vec2 b) {
  return (a.y > p.y) != (b.y > p.y) && orientation_sign(a, b, p) == (b.y > a.y ? 1 : -1);
}

/// Whether two segments have a place in common: they cross, touch or lie over each other. Either may be a single
/// point. The same whichever is named first and whichever way they run. REQUIRES: finite coordinates.
bool segments_meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// A place of the segment (a, b) near where (c, d) meets it: the very end of one where that lies on the other, else
/// rounded. For messages and for marking. REQUIRES: segments_meet().
Vec2 meeting_place(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// Whether a line that goes from a to b and on to c runs back over where it came from. REQUIRES: b is neither a nor c.
bool turns_back(Vec2 a, Vec2 b, Vec2 c);

}  // namespace seamount::geom
