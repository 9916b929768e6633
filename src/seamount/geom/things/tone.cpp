#include "seamount/geom/things/tone.h"

#include <algorithm>
#include <cmath>

namespace seamount::geom {
namespace {

double linear(unsigned char encoded) {
  const double e = encoded / 255.0;
  return e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4);
}

unsigned char encoded(double linear) {
  const double l = std::clamp(linear, 0.0, 1.0);
  const double e = l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1.0 / 2.4) - 0.055;
  return static_cast<unsigned char>(std::lround(255.0 * e));
}

}  // namespace

Tone tone(Colour srgb) { return {linear(srgb.r), linear(srgb.g), linear(srgb.b)}; }

Tone tone(unsigned rgb) {
  return tone(Colour{static_cast<unsigned char>(rgb >> 16 & 255U), static_cast<unsigned char>(rgb >> 8 & 255U),
                     static_cast<unsigned char>(rgb & 255U)});
}

Colour srgb(Tone linear) { return {encoded(linear.r), encoded(linear.g), encoded(linear.b)}; }

}  // namespace seamount::geom
