// Slope modulation along a curve as a map of the plane (P2 sec. 5.3): places within a radius of the curve are drawn
// towards it or pushed off, so that contours lie closer together or further apart near it.
//
// P2's delta(x) = x (1 - x) is the family (4 x (1 - x))^k for k = 1 at its bound: with u the distance over the radius,
// u -> u - mu c_k u (4 u (1 - u))^k keeps its order for |mu| <= 1 where c_k = 1 / max |(u (4 u (1 - u))^k)'|, and
// c_1 = 1/4. At a point the map is one to one; along a curve only where it bends with a radius above the tool's, which
// the check of the moved contours then finds out.
#pragma once

#include <span>

#include "seamount/base/run_context.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/model/drawn.h"
#include "seamount/ops/contour/move/displacement.h"

namespace seamount::contour {

class Squeeze {
 public:
  /// Along the Catmull-Rom spline through the points, or about the only one. REQUIRES: a point, radius_m > 0, k >= 1.
  Squeeze(const Polyline& stroke, double radius_m, int k);

  /// strength in [-1, 1]: above 0 towards the curve. Parallel; about 5 ns for each place and each piece of the curve
  /// near it.
  void move(double strength, std::span<Vec2> places, const RunContext& run) const;

  bool touches(const geom::Box& box) const;
  const geom::Box& reach() const { return reach_; }

  /// Share of the distance to the curve by which a place at `u` radii from it comes nearer at strength 1.
  double share(double u) const { return scale_ * displacement_(u); }

 private:
  Vec2 moved(double strength, Vec2 place, std::span<const size_t> near) const;
  double squared_distance(size_t piece, Vec2 place, Vec2& nearest) const;

  Polyline line_;  ///< pieces [i, i + 1]; two equal points for a single one
  double radius_m_;
  Displacement displacement_;
  double scale_ = 0.0;
  geom::Box reach_;
};

}  // namespace seamount::contour
