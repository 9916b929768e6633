// The way of a brush stroke over a grid, as places at even steps along its spline.
//
// The spline is that of sample_catmull_rom(), pressure running with the place. Each part between two points is a Bezier
// curve whose hull tells whether it can reach the grid at all, so a point may lie as far away as it likes; what does is
// halved until it is straight. The steps are those that a Gaussian of the stroke's spread is summed exactly with.
#pragma once

#include <string>
#include <vector>

#include "seamount/geom/polygon/polygon.h"
#include "seamount/model/brush.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// What a stroke weighs at a distance from its line: 1 up to `plateau_m`, then (1 - s^2)^3 with s running to 1 over
/// `fall_m`, so that neither slope nor curvature jumps at the rim.
///
/// Distances come as squares that lie somewhat below 0 where the stroke curls up. They are rounded first, in squared
/// radii: rounded(v) = G(v) / G(1), G(v) = (v + sqrt(v^2 + k^2) - k) / 2, k = 0.01, never below -0.005.
struct BrushProfile {
  double plateau_m = 0.0;
  double fall_m = 1.0;
  double radius_m() const { return plateau_m + fall_m; }
  double weight(double distance_m) const;
};

inline constexpr double kBrushRounding = 0.01;  ///< k

/// A place on the way. See brush_rows.h for what the numbers are for.
struct BrushSample {
  Vec2 at;
  double pressure = 1.0;
  double mass = 1.0;       ///< length that it stands for, more where pressure is high
  double spread_m2 = 0.0;  ///< square of the spread that it adds to distances
};

struct BrushPath {
  std::vector<BrushSample> samples;  ///< those that reach the grid, in their order
  BrushProfile profile;
  double spread_m = 1.0;  ///< deviation of the Gaussian by which parts of the stroke count
  double thinned = 1.0;   ///< radius that was asked for over that of the profile, which is at least 3/4 of a cell
  bool even = true;       ///< pressure is the same all along
  Box box;                ///< of all that the samples reach
};

/// A stroke on a grid. Finer than the grid's cells it is as wide as a cell; nothing falls off within less than a cell.
/// Pressure of points that lie on each other: the greatest. Throws InvalidArgument{name + ".points"} without points
/// and for a place that is none or beyond 1e12 m, {name + ".pressure"} where there is not one for each point. Linear in
/// the points, and in what of the stroke reaches the grid.
BrushPath brush_path(const Brush& brush, const GridFrame& frame, const std::string& name);

}  // namespace seamount::geom
