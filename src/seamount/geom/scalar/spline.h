// Splines through drawn points and the closest place on them (strokes, P0 sec. 1.4.1).
//
// Catmull-Rom with centripetal knots (Yuksel, Schaefer and Keyser 2011): unlike the uniform kind it makes no loop and
// no cusp within a segment, however unevenly the points were drawn.
#pragma once

#include "seamount/model/drawn.h"

namespace seamount::geom {

/// Points at most about step_m apart along the centripetal Catmull-Rom spline through all control points, which are
/// among them. The spline's ends are shaped by reflecting the second point in the first and the last but one in the
/// last. Repeated points are dropped; fewer than two different points come back as they are. Throws InvalidArgument
/// unless step_m > 0 and there are at most ten million of them. Linear in the length / step_m.
Polyline sample_catmull_rom(const Polyline& control, double step_m);

/// A place on a polyline.
struct Closest {
  Vec2 point;             ///< the place itself
  Vec2 tangent;           ///< unit direction of travel, continuous along the polyline
  double distance = 0.0;  ///< from the query to point, metres
  double along = 0.0;     ///< length of the polyline up to point, metres
};

/// Closest place on a polyline; of several the first. The tangent runs linearly between the vertices' tangents (mean of
/// the unit directions on both sides), so it does not jump at a vertex. One point has tangent {0, 0}.
/// Throws InvalidArgument for an empty polyline. Linear time.
Closest closest_on_polyline(const Polyline& line, Vec2 p);

}  // namespace seamount::geom
