// An edge, or a point, prepared for exact distances from many places.
#pragma once

#include <algorithm>

#include "seamount/model/drawn.h"

namespace seamount::geom {

struct PointEdge {
  Vec2 a, along;
  double inverse;  ///< 1 / |along|^2, 0 for a point

  static PointEdge between(Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const double squared = dot(along, along);
    return {a, along, squared > 0.0 ? 1.0 / squared : 0.0};
  }

  double share_nearest(Vec2 p) const { return std::clamp(dot(p - a, along) * inverse, 0.0, 1.0); }

  double squared_distance(Vec2 p) const {
    const Vec2 off = p - a - share_nearest(p) * along;
    return dot(off, off);
  }
};

}  // namespace seamount::geom
