// Small-scale noise for shading: gradient noise in float together with its slope, for tens of millions of single points
// (geom/scalar/noise.h works along rows of a grid). Octaves finer than the footprint of a pixel fade out, so
// nothing shimmers.
#pragma once

#include <cmath>
#include <cstdint>

namespace seamount::render {

/// A noise value and its derivatives along x and y, per metre.
struct NoiseSample {
  float value = 0.0F, dx = 0.0F, dy = 0.0F;
};

namespace detail {

inline uint32_t lattice_hash(uint32_t seed, int32_t x, int32_t y) {
  uint32_t h = seed ^ (static_cast<uint32_t>(x) * 0x9e3779b1U) ^ (static_cast<uint32_t>(y) * 0x85ebca77U);
  h = (h ^ (h >> 15)) * 0x2c1b3c6dU;
  h = (h ^ (h >> 12)) * 0x297a2d39U;
  return h ^ (h >> 15);
}

struct Slope {
  float x, y;
};

/// A lattice gradient of length about 1.
inline Slope lattice_slope(uint32_t hash) {
  constexpr float kScale = 1.6F / 65535.0F;
  return {static_cast<float>(hash & 0xffffU) * kScale - 0.8F, static_cast<float>(hash >> 16) * kScale - 0.8F};
}

inline float fast_floor(float x) {
  const auto whole = static_cast<float>(static_cast<int32_t>(x));
  return whole > x ? whole - 1.0F : whole;
}

}  // namespace detail

/// Perlin noise of unit wavelength, about [-0.7, 0.7], with its gradient.
inline NoiseSample gradient_noise(uint32_t seed, float x, float y) {
  const float fx = detail::fast_floor(x), fy = detail::fast_floor(y);
  const auto ix = static_cast<int32_t>(fx), iy = static_cast<int32_t>(fy);
  const float u = x - fx, v = y - fy;
  const detail::Slope a = detail::lattice_slope(detail::lattice_hash(seed, ix, iy));
  const detail::Slope b = detail::lattice_slope(detail::lattice_hash(seed, ix + 1, iy));
  const detail::Slope c = detail::lattice_slope(detail::lattice_hash(seed, ix, iy + 1));
  const detail::Slope d = detail::lattice_slope(detail::lattice_hash(seed, ix + 1, iy + 1));
  const float na = a.x * u + a.y * v, nb = b.x * (u - 1.0F) + b.y * v;
  const float nc = c.x * u + c.y * (v - 1.0F), nd = d.x * (u - 1.0F) + d.y * (v - 1.0F);
  const float su = u * u * u * (u * (u * 6.0F - 15.0F) + 10.0F), sv = v * v * v * (v * (v * 6.0F - 15.0F) + 10.0F);
  const float du = 30.0F * u * u * (u * (u - 2.0F) + 1.0F), dv = 30.0F * v * v * (v * (v - 2.0F) + 1.0F);
  const float k = na - nb - nc + nd;
  return {na + su * (nb - na) + sv * (nc - na) + su * sv * k,
          a.x + su * (b.x - a.x) + sv * (c.x - a.x) + su * sv * (a.x - b.x - c.x + d.x) + du * (nb - na + sv * k),
          a.y + su * (b.y - a.y) + sv * (c.y - a.y) + su * sv * (a.y - b.y - c.y + d.y) + dv * (nc - na + su * k)};
}

/// Sum of octaves from `wavelength` metres down, each half as long and `gain` as high as the one before; deviation
/// about 0.3. Octaves shorter than about three footprints are faded out, what is below two is skipped.
inline NoiseSample detail_noise(uint32_t seed, float x, float y, float wavelength, int octaves, float gain,
                                float footprint) {
  NoiseSample sum;
  float amplitude = 1.0F;
  // Each octave is turned by about 37 degrees against the one before, so that no direction of the lattice adds up; and
  // the first by 23 degrees against x and y: far off it is the only one left, and its lattice would show as a plaid.
  float cosine = 0.921F, sine = -0.390F;
  const float first = cosine * x - sine * y;
  y = sine * x + cosine * y;
  x = first;
  for (int i = 0; i < octaves; ++i) {
    const float fade = wavelength / footprint - 2.0F;
    if (fade <= 0.0F) break;
    const float weight = amplitude * (fade < 1.0F ? fade : 1.0F);
    const float frequency = 1.0F / wavelength;
    const NoiseSample octave =
        gradient_noise(seed + static_cast<uint32_t>(i) * 0x68bc21ebU, x * frequency, y * frequency);
    sum.value += weight * octave.value;
    sum.dx += weight * frequency * (cosine * octave.dx + sine * octave.dy);
    sum.dy += weight * frequency * (cosine * octave.dy - sine * octave.dx);
    wavelength *= 0.5F;
    amplitude *= gain;
    const float turned = 0.8F * x - 0.6F * y;
    y = 0.6F * x + 0.8F * y;
    x = turned;
    const float turned_cosine = 0.8F * cosine - 0.6F * sine;
    sine = 0.6F * cosine + 0.8F * sine;
    cosine = turned_cosine;
  }
  return sum;
}

}  // namespace seamount::render
