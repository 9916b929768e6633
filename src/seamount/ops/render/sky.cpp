#include "seamount/ops/render/sky.h"

namespace seamount::render {
namespace {

// Radiance of a clear sky, in units in which sunlight on a white card that faces a high sun is about 2.6.
constexpr Rgb kZenith{0.105F, 0.225F, 0.500F};
constexpr Rgb kMiddle{0.270F, 0.440F, 0.720F};
constexpr Rgb kHorizon{0.640F, 0.740F, 0.850F};
constexpr Rgb kGlow{1.00F, 0.82F, 0.58F};
// Of a low sun: along the horizon, and around itself.
constexpr Rgb kDuskHorizon{0.980F, 0.620F, 0.400F};
constexpr Rgb kDuskGlow{1.35F, 0.62F, 0.22F};

}  // namespace

Sky::Sky(SunDirection sun) {
  const double flat = std::cos(sun.elevation);
  to_sun_ = {static_cast<float>(flat * std::sin(sun.azimuth)), static_cast<float>(flat * std::cos(sun.azimuth)),
             static_cast<float>(std::sin(sun.elevation))};
  // Optical depth of a clear atmosphere for red, green and blue times the relative air mass (Kasten's shape).
  const float air_mass = 1.0F / (std::max(0.0F, to_sun_.z) + 0.06F);
  sun_light_ = 3.55F * exp_of(-air_mass * Rgb{0.095F, 0.150F, 0.255F});
  const float day = 0.35F + 0.65F * ramp(0.0F, 0.5F, to_sun_.z);
  sky_light_ = day * Rgb{0.345F, 0.435F, 0.585F};
}

float Sky::exposure() const {
  const auto on_the_ground = [](const Sky& sky) {
    return luminance(std::max(0.02F, sky.to_sun_.z) * sky.sun_light_ + sky.sky_light_);
  };
  static const float usual = on_the_ground(Sky({0.0, 0.5235988}));
  return std::pow(usual / on_the_ground(*this), 0.6F);
}

Rgb Sky::radiance(Vec3 direction) const {
  const float up = std::max(0.0F, direction.z);
  const float low = std::exp(-13.0F * up), middle = std::exp(-2.8F * up);
  const float toward = std::max(0.0F, dot(direction, to_sun_));
  const float warm = toward * toward * toward;
  const float dusk = ramp(0.30F, 0.04F, to_sun_.z);
  // The dusk's colour lies along the horizon, most on the sun's side.
  const Rgb horizon = mix(kHorizon, kDuskHorizon, dusk * (0.35F + 0.65F * warm));
  const Rgb sun_glow = mix(kGlow, kDuskGlow, dusk);
  Rgb colour = mix(kZenith, mix(kMiddle, horizon, low), middle);
  const float glow = (0.22F * warm + 0.25F * warm * warm * warm) * (0.25F + 0.75F * low);
  colour = mix(colour, sun_glow, clamp01(glow * (1.0F + dusk)));
  return (0.35F + 0.65F * ramp(0.0F, 0.5F, to_sun_.z)) * colour;
}

Rgb Sky::haze(Vec3 direction) const {
  const float flat = std::sqrt(direction.x * direction.x + direction.y * direction.y);
  if (flat < 1e-4F) return radiance({1.0F, 0.0F, 0.0F});
  return radiance({direction.x / flat, direction.y / flat, 0.0F});
}

}  // namespace seamount::render
