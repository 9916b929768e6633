// How a terrain lies: slope, aspect and curvatures at every cell.
//
// Stencil: the quadratic z = r x^2 / 2 + s x y + t y^2 / 2 + p x + q y + c that fits the 3 x 3 cells around best in the
// sense of least squares (Evans 1980; Florinsky, Digital Terrain Analysis in Soil Science and Geology, 2016, ch. 4).
// Beyond the frame's edge heights go on linearly (z(-1) = 2 z(0) - z(1)), so a plane has one slope everywhere.
// Curvatures are of normal sections, in 1/m, POSITIVE WHERE THE GROUND IS CONVEX (ridges, noses, crests):
//
//   profile  along the line of fall   -(p^2 r + 2 p q s + q^2 t) / (g (1 + g)^(3/2)),  g = p^2 + q^2
//   plan     along the contour        -(q^2 r - 2 p q s + p^2 t) / (g (1 + g)^(1/2))
//   mean     of any two at right angles, half the sum of both; where the ground is level (g = 0) all three are this one
//
// For forms of a given size in metres take the terrain at_scale() first.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Derivatives of the fitted quadratic in a cell's middle; x east, y north, metres.
struct SurfaceFit {
  double p = 0.0;  ///< dz/dx
  double q = 0.0;  ///< dz/dy
  double r = 0.0;  ///< d2z/dx2
  double s = 0.0;  ///< d2z/dx dy
  double t = 0.0;  ///< d2z/dy2

  double slope_deg() const;
  /// Bearing of the line of fall, clockwise from north, in [0, 360); -1 where the ground is level.
  double aspect_deg() const;
  double profile_curvature() const;
  double plan_curvature() const;
  double mean_curvature() const;
};

/// One cell, in double: the plain form of the functions below. REQUIRES: a cell of the terrain.
SurfaceFit fit_surface(const HeightField& terrain, int x, int y);

/// The terrain without forms smaller than about `scale_m`: a Gaussian blur of deviation scale_m / 2 that takes heights
/// to go on linearly beyond the edge, so that slopes there stay. A copy for scales below one cell. Parallel; two more
/// grids.
HeightField at_scale(const HeightField& terrain, double scale_m, const RunContext& run);

/// Cells on every side that a cell of at_scale() hangs on; 0 below one cell. Saturates at 2^24.
int scale_reach(double scale_m, double cell_m);

enum class Curvature { profile, plan, mean };

/// Steepness in degrees, [0, 90]. Parallel, vectorised; agrees with fit_surface() to 1e-3 degrees on heights whose
/// float rounding is small against the slope.
ScalarField slope_deg(const HeightField& terrain, const RunContext& run);

/// Downhill bearing in degrees clockwise from north, [0, 360); -1 where the ground is level. Parallel.
ScalarField aspect_deg(const HeightField& terrain, const RunContext& run);

/// Curvature in 1/m, positive where convex. Parallel, vectorised.
ScalarField curvature(const HeightField& terrain, Curvature kind, const RunContext& run);

}  // namespace seamount::geom
