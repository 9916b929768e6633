// Skeletons drawn along by hand (P3 sec. 1.7.1).
#pragma once

#include "seamount/model/scene_edits.h"
#include "seamount/model/skeleton.h"

namespace seamount::geom {

/// A hold on the plane that is drawn along. The place `at` moves by exactly `by`, others by less with their distance d:
///   gaussian   exp(-d^2 / (2 radius^2)) by, everything in one direction
///   kelvinlet  the regularised grab of geom/scalar/kelvinlet.h, epsilon = radius, a displacement instead of a speed:
///              it reaches further (as 1 / d), and what lies beside it follows less than what lies ahead
struct BendHandle {
  Vec2 at;
  Vec2 by;                  ///< metres
  double radius_m = 100.0;  ///< > 0
  Handle kind = Handle::gaussian;
  double poisson_ratio = 0.5;  ///< nu of a kelvinlet, in [0, 0.5]; 0.5 neither gathers nor spreads
};

/// By how much a place moves. REQUIRES: handle in its ranges.
Vec2 displacement(const BendHandle& handle, Vec2 place);

/// A skeleton elsewhere.
Skeleton moved(const Skeleton& skeleton, Vec2 by);

/// A skeleton whose points all moved with the handle, held ones too: people decide. Edges near it are first split to at
/// most a third of its radius, so that few points bend as well as many; a new point is held as its freer neighbour.
/// With `lock`, points that moved by more than half of |by| are held fast (hold 1) from now on. Throws
/// InvalidArgument{"by"} where a curve or an outline that did not cross itself would do so, or an outline would turn
/// inside out: shorter steps or a larger radius then; InvalidArgument for numbers out of range, and where it would take
/// more than a million points. About linear in the points. It is undone by keeping the old skeleton, not by bending
/// back.
Skeleton bent(const Skeleton& skeleton, const BendHandle& handle, bool lock);

/// Sets the hold of the points within radius_m of a place, in [0, 1].
Skeleton held(const Skeleton& skeleton, Vec2 at, double radius_m, double hold);

}  // namespace seamount::geom
