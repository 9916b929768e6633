// Colours of things in linear light, where they are mixed and shaded.
#pragma once

#include "seamount/model/drawn.h"

namespace seamount::geom {

/// Linear light, the primaries of sRGB.
struct Tone {
  double r = 0.0, g = 0.0, b = 0.0;
  friend Tone operator+(Tone a, Tone c) { return {a.r + c.r, a.g + c.g, a.b + c.b}; }
  friend Tone operator*(double s, Tone a) { return {s * a.r, s * a.g, s * a.b}; }
};

inline Tone mix(Tone a, Tone b, double t) { return (1.0 - t) * a + t * b; }

Tone tone(Colour srgb);
/// 0xA39D94, as colours are written.
Tone tone(unsigned rgb);
/// Rounded after clamping.
Colour srgb(Tone linear);

}  // namespace seamount::geom
