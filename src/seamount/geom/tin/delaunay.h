// Delaunay triangulation: no point lies inside the circle through the corners of any triangle.
//
// Incremental insertion (Bowyer 1981, Watson 1981) with a vertex at infinity that closes the hull, in rounds of random
// points along a space-filling curve (Amenta, Choi and Rote 2003), so that each point is found a few triangles from the
// one before. Predicates are exact, so nothing depends on tolerances. Chosen over Boost.Polygon's sweep, which has no
// advantage in exactness on a lattice and takes several times as long.
#pragma once

#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/polygon/lattice_points.h"
#include "seamount/geom/tin/delaunay_builder.h"

namespace seamount::geom {

/// Triangles of the convex hull, each with its smallest corner first and in the order of these. Of points in one place
/// the triangles use only one; points that all lie on one line have no triangles. Where four points lie on one circle
/// either diagonal. REQUIRES: coordinates in [0, 2^29), fewer than 2^29 points. Expected n log n, about 0.6 us and 70
/// bytes per point; serial; fastest if the points come in spatial_order.
std::vector<Triangle> delaunay(std::span<const LatticePoint> points, const RunContext& run);

/// The same for places in metres, which are first snapped to 2^-29 of their extent. REQUIRES: finite coordinates.
std::vector<Triangle> delaunay(std::span<const Vec2> points, const RunContext& run);

}  // namespace seamount::geom
