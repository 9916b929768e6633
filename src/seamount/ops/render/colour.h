// Linear-light colours, their way to 8-bit sRGB pixels, and mixing that looks even. Rendering happens in linear light
// with the primaries of sRGB; ramps are mixed in Oklab (B. Ottosson, "A perceptual color space for image processing",
// 2020), where equal steps look equal.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "seamount/geom/scalar/blend.h"
#include "seamount/model/drawn.h"

namespace seamount::render {

/// Linear light, 1 = a white surface in full light. Also used for any per-channel quantity (absorption).
struct Rgb {
  float r = 0.0F, g = 0.0F, b = 0.0F;

  friend Rgb operator+(Rgb a, Rgb c) { return {a.r + c.r, a.g + c.g, a.b + c.b}; }
  friend Rgb operator-(Rgb a, Rgb c) { return {a.r - c.r, a.g - c.g, a.b - c.b}; }
  friend Rgb operator*(Rgb a, Rgb c) { return {a.r * c.r, a.g * c.g, a.b * c.b}; }
  friend Rgb operator*(float s, Rgb a) { return {s * a.r, s * a.g, s * a.b}; }
  Rgb& operator+=(Rgb c) { return *this = *this + c; }
  bool operator==(const Rgb&) const = default;
};

inline Rgb mix(Rgb a, Rgb b, float t) { return a + t * (b - a); }
inline float mix(float a, float b, float t) { return a + t * (b - a); }
inline float luminance(Rgb c) { return 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b; }
inline Rgb exp_of(Rgb c) { return {std::exp(c.r), std::exp(c.g), std::exp(c.b)}; }

inline float clamp01(float x) { return x < 0.0F ? 0.0F : (x > 1.0F ? 1.0F : x); }

/// 0 below `low`, 1 above `high`, smooth between; also for low > high (falling).
inline float ramp(float low, float high, float x) { return geom::smoothstep((x - low) / (high - low)); }

/// sRGB transfer function and its inverse on [0, 1].
float srgb_from_linear(float linear);
float linear_from_srgb(float encoded);

Rgb linear(Colour colour);
/// Rounded to 8 bits after clamping.
Colour srgb(Rgb linear);

/// Mixes by equal perceived steps: t = 0 gives a, t = 1 gives b.
Rgb mix_perceptual(Rgb a, Rgb b, float t);
/// Perceived lightness in [0, 1] (Oklab L).
float lightness(Rgb linear);

/// Film-like curve from scene light to display light: slope about 1 in the shadows, shoulder that keeps the hue of
/// bright colours (a share of the curve acts on the luminance alone).
Rgb tone_curve(Rgb scene);

/// Writes a display-linear colour as 8-bit sRGB at a pixel, with hashed noise of one step against banding:
/// a function of the pixel alone.
void write_dithered(uint8_t* pixel, int x, int y, Rgb display);

}  // namespace seamount::render
