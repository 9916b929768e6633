// Sun, sky and haze: an analytic clear maritime sky in the manner of simple daylight models (a gradient from zenith to
// horizon, a forward-scattering glow around the sun), tuned by eye, not measured. Also what haze does with distance.
#pragma once

#include "seamount/ops/render/colour.h"
#include "seamount/ops/render/light.h"

namespace seamount::render {

/// A direction or normal; z up, x east, y north.
struct Vec3 {
  float x = 0.0F, y = 0.0F, z = 0.0F;
  friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator*(float s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
};
inline float dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 normalised(Vec3 a) { return (1.0F / std::sqrt(dot(a, a))) * a; }

class Sky {
 public:
  explicit Sky(SunDirection sun);

  Vec3 to_sun() const { return to_sun_; }
  /// Light of the sun on a surface that faces it.
  Rgb sun_light() const { return sun_light_; }
  /// Light of the whole sky on level ground.
  Rgb sky_light() const { return sky_light_; }
  /// How much longer a film is exposed than in the light of a sun 30 degrees high: an evening is not drawn as dark as
  /// it is, nor quite as bright.
  float exposure() const;
  /// What one sees in a direction (below the horizon: the horizon), without the sun's disc. REQUIRES: unit length.
  Rgb radiance(Vec3 direction) const;
  /// What haze adds in a direction: the horizon's colour there.
  Rgb haze(Vec3 direction) const;

 private:
  Vec3 to_sun_;
  Rgb sun_light_, sky_light_;
};

/// Haze with distance; blue light is lost first. Thickens beyond the terrain, so that a sea fades into its horizon.
struct Haze {
  float near_density = 0.0F;  ///< optical depth per metre
  float far_length = 1e9F;    ///< metres after which it has doubled
  Rgb transmittance(float distance) const {
    const float depth = near_density * distance * (1.0F + distance / far_length);
    return {std::exp(-0.7F * depth), std::exp(-depth), std::exp(-1.5F * depth)};
  }
};

}  // namespace seamount::render
