// How curves and regions change the current around them (P3 sec. 1.6.3, fig. 1.35 and 1.42).
#pragma once

#include <span>

#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/vector_field.h"

namespace seamount::geom {

/// A canyon, a reef: Kelvinlets at the place of the curve that is closest.
struct CurveFlow {
  Polyline line;              ///< at least two points, metres
  double radius_m = 100.0;    ///< eps of the Kelvinlets, > 0; the flow ends at 4 radii
  double along_m_s = 0.0;     ///< the speed on the curve, in its direction; negative against it (a grab, Poisson 0.5)
  double outwards_m_s = 0.0;  ///< the largest speed away from it, 0.57 radii beside it; negative towards it (a scale)
};

/// Adds curves' flow to a current: at r from the curve's closest point, the grab along its direction there and the
/// scale of kelvinlet.h, times 1 up to 2 radii and smoothly less up to 4, so that a curve costs what lies within its
/// reach. Where several parts of a curve are about equally near, direction and offset are their mean, weighted over a
/// third of the radius: those of the closest alone jump there. InvalidArgument "curves[3]" for fewer than two different
/// points, a radius that is not above 0 or numbers that are none. Parallel over curves, added in their order.
void add_curve_flow(std::span<const CurveFlow> curves, VectorField& current, const RunContext& run);

/// An island, a lagoon, a reef flat.
struct RegionFlow {
  Polygon outline;             ///< metres, in either direction
  double reach_m = 200.0;      ///< > 0
  double seaward_m_s = 0.0;    ///< the obstacle: away from the region, fastest on its outline; negative into it
  double shoreward_m_s = 0.0;  ///< waves: towards the outline from outside, fastest a third of the reach off it
};

/// Adds regions' flow to a current. P3 takes the vector to the closest point of the outline, scaled by its distance;
/// unbounded, it would be fastest where the region matters least. Here, with n the direction away from the region and
/// t = |d| / reach the share of the reach at distance d,
///
///   flow = n (seaward (1 - t^2)^2 - shoreward [outside] 27/4 t (1 - t)^2),
///
/// which is 0 from the reach on, on both sides of the outline. n is the gradient of the signed distance over two cells:
/// in the middle of a narrow region, or of a bay, where two coasts are equally near, opposite pushes cancel. Between
/// two islands closer than two reaches they cancel likewise, and what they shed settles there (P3 fig. 1.27).
/// InvalidArgument "regions[3]". Costs the cells within each region's reach; parallel, added in their order.
void add_region_flow(std::span<const RegionFlow> regions, VectorField& current, const RunContext& run);

}  // namespace seamount::geom
