// Contours moved by a map of the plane (P2 sec. 5.2, appendix C): edges are subdivided before, the result is thinned
// after, and that nothing crosses is checked.
//
// A one to one map keeps contours apart, but a polygon is only moved at its vertices, and appendix C shows that no
// spacing of vertices is safe by itself. So where a check finds a crossing, edges about it are left as they were
// subdivided, then halved and halved again; if that does not help, the map is weakened until nothing crosses.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/model/contour_set.h"

namespace seamount::contour {

/// A map of the plane of a chosen strength: the identity at 0 and outside `reach`, and nothing leaves `reach`.
struct PlaneMap {
  geom::Box reach;
  double edge_m = 0.0;                            ///< edges that it touches are subdivided to this length at most
  double tolerance_m = 0.0;                       ///< points made by subdividing go again where they tell less
  std::function<bool(const geom::Box&)> touches;  ///< may anything within the box move?
  std::function<void(double strength, std::span<Vec2> places, const RunContext&)> move;
};

struct Moved {
  double strength = 0.0;         ///< what was applied
  std::optional<Vec2> crossing;  ///< where contours would have met at the strength that was asked for
};

/// Moves the contours, as strongly as can be without a crossing, at most by `strength`. Vertices of contours stay
/// vertices; contours out of reach stay as they are. Throws IncompatibleInputs where contours cross already within
/// reach. Parallel; about 5 ns a vertex to look at, and what the map and the check take for those in reach.
Moved move_contours(std::vector<Contour>& contours, const PlaneMap& map, double strength, const RunContext& run);

}  // namespace seamount::contour
