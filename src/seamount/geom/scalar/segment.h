// The place of a straight line's part that lies nearest to another place.
#pragma once

#include <algorithm>

#include "seamount/model/drawn.h"

namespace seamount::geom {

/// Where the segment from a to b comes nearest to p, as a share of its length; 0 for one without length.
inline double nearest_share(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double squared = dot(along, along);
  return squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
}

inline Vec2 nearest_on_segment(Vec2 p, Vec2 a, Vec2 b) { return a + nearest_share(p, a, b) * (b - a); }

inline double squared_distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 off = p - nearest_on_segment(p, a, b);
  return dot(off, off);
}

}  // namespace seamount::geom
