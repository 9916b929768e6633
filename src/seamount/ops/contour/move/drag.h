// The warp along a stroke as a map of the plane (P2 sec. 5.2): a disc is dragged along the stroke, and each of its
// steps is a map that is one to one and moves nothing outside the disc.
//
// Departures: the stroke is a Catmull-Rom spline through the drawn points; maps are applied in path order, first
// segment first, so that a point is carried along (P2 prints the opposite order). As printed the drag falls off to the
// sides like a half circle, upright at the rim, and contours would be creased along both sides of the stroke; it is
// multiplied by (chord / diameter)^(2 k), which is 1 at the centre and at most 1, so that P2's laws and bound hold.
#pragma once

#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/model/drawn.h"
#include "seamount/ops/contour/move/displacement.h"

namespace seamount::contour {

/// f_i of P2: places in the disc around `centre` are moved along the unit vector `direction`, the centre by `step_m`.
struct DragStep {
  Vec2 centre, direction;
  double step_m = 0.0;
};

class Drag {
 public:
  /// Equal segments of at most `segment_m` along the stroke. REQUIRES: two different points, radius and segment > 0.
  Drag(const Polyline& stroke, double radius_m, double segment_m, Displacement displacement);

  /// Carries each place along, by `strength` in [0, 1] of the whole. Parallel; about 10 ns for each place and step
  /// whose disc it is in.
  void move(double strength, std::span<Vec2> places, const RunContext& run) const;
  Vec2 moved(double strength, Vec2 place) const;

  /// Does any step reach into the box?
  bool touches(const geom::Box& box) const;

  const std::vector<DragStep>& steps() const { return steps_; }
  double radius_m() const { return radius_m_; }
  /// Everything that can move lies in it.
  const geom::Box& reach() const { return reach_; }

 private:
  Vec2 moved_by(const DragStep& step, double strength, Vec2 place) const;
  void move_block(double strength, std::span<Vec2> places) const;

  double radius_m_;
  Displacement displacement_;
  std::vector<DragStep> steps_;
  geom::Box reach_;
};

}  // namespace seamount::contour
