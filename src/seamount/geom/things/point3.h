// Points and directions in space, and noise there, for the makers of things.
#pragma once

#include <cmath>

#include "seamount/base/rng.h"

namespace seamount::geom {

struct Point3 {
  double x = 0.0, y = 0.0, z = 0.0;
  friend Point3 operator+(Point3 a, Point3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Point3 operator-(Point3 a, Point3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Point3 operator*(double s, Point3 a) { return {s * a.x, s * a.y, s * a.z}; }
  bool operator==(const Point3&) const = default;
};

inline double dot(Point3 a, Point3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point3 cross(Point3 a, Point3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Point3 a) { return std::sqrt(dot(a, a)); }
/// Unit length; up, where there is no direction.
inline Point3 unit(Point3 a) {
  const double l = length(a);
  return l > 1e-12 ? (1.0 / l) * a : Point3{0.0, 0.0, 1.0};
}
inline Point3 mix(Point3 a, Point3 b, double t) { return a + t * (b - a); }
/// Direction by its bearing from x towards y and its height over the horizon, radians.
inline Point3 direction(double bearing, double height) {
  return {std::cos(height) * std::cos(bearing), std::cos(height) * std::sin(bearing), std::sin(height)};
}
/// Any unit vector square to a unit vector.
inline Point3 beside(Point3 a) {
  return unit(std::abs(a.z) < 0.9 ? cross({0.0, 0.0, 1.0}, a) : cross({1.0, 0.0, 0.0}, a));
}

/// Smooth noise of unit wavelength in [-1, 1], deviation about 0.4: values at lattice points, mixed by quintics.
double noise3(Seed seed, Point3 at);

}  // namespace seamount::geom
