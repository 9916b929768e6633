#include "seamount/ops/render/colour.h"

#include <array>

#include "seamount/base/rng.h"

namespace seamount::render {
namespace {

struct Lab {
  float l, a, b;
};

Lab to_oklab(Rgb c) {
  const float l = std::cbrt(0.4122214708F * c.r + 0.5363325363F * c.g + 0.0514459929F * c.b);
  const float m = std::cbrt(0.2119034982F * c.r + 0.6806995451F * c.g + 0.1073969566F * c.b);
  const float s = std::cbrt(0.0883024619F * c.r + 0.2817188376F * c.g + 0.6299787005F * c.b);
  return {0.2104542553F * l + 0.7936177850F * m - 0.0040720468F * s,
          1.9779984951F * l - 2.4285922050F * m + 0.4505937099F * s,
          0.0259040371F * l + 0.7827717662F * m - 0.8086757660F * s};
}

Rgb from_oklab(Lab c) {
  const float l = c.l + 0.3963377774F * c.a + 0.2158037573F * c.b;
  const float m = c.l - 0.1055613458F * c.a - 0.0638541728F * c.b;
  const float s = c.l - 0.0894841775F * c.a - 1.2914855480F * c.b;
  const float l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
  return {4.0767416621F * l3 - 3.3077115913F * m3 + 0.2309699292F * s3,
          -1.2684380046F * l3 + 2.6097574011F * m3 - 0.3413193965F * s3,
          -0.0041960863F * l3 - 0.7034186147F * m3 + 1.7076147010F * s3};
}

/// sRGB encoding tabulated over the square root of linear light, where it is nearly straight: error below 1e-4.
struct EncodingTable {
  static constexpr int kSteps = 1024;
  std::array<float, kSteps + 2> value{};
  EncodingTable() {
    for (int i = 0; i <= kSteps + 1; ++i) {
      const float root = static_cast<float>(i) / kSteps;
      value[static_cast<size_t>(i)] = srgb_from_linear(std::min(1.0F, root * root));
    }
  }
  float operator()(float linear) const {
    const float place = std::sqrt(clamp01(linear)) * kSteps;
    const int i = static_cast<int>(place);
    const float f = place - static_cast<float>(i);
    return mix(value[static_cast<size_t>(i)], value[static_cast<size_t>(i) + 1], f);
  }
};

float film(float x) {
  // Rational curve through the origin with a toe, slope near 1 and a shoulder that reaches 1 at about 8.
  return clamp01(x * (2.43F * x + 0.10F) / (x * (2.30F * x + 0.86F) + 0.16F));
}

}  // namespace

float srgb_from_linear(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

float linear_from_srgb(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

Rgb linear(Colour colour) {
  return {linear_from_srgb(static_cast<float>(colour.r) / 255.0F),
          linear_from_srgb(static_cast<float>(colour.g) / 255.0F),
          linear_from_srgb(static_cast<float>(colour.b) / 255.0F)};
}

Colour srgb(Rgb linear) {
  const auto byte = [](float x) { return static_cast<unsigned char>(srgb_from_linear(clamp01(x)) * 255.0F + 0.5F); };
  return {byte(linear.r), byte(linear.g), byte(linear.b)};
}

Rgb mix_perceptual(Rgb a, Rgb b, float t) {
  const Lab p = to_oklab(a), q = to_oklab(b);
  const Rgb c = from_oklab({mix(p.l, q.l, t), mix(p.a, q.a, t), mix(p.b, q.b, t)});
  return {clamp01(c.r), clamp01(c.g), clamp01(c.b)};
}

float lightness(Rgb linear) { return to_oklab(linear).l; }

Rgb tone_curve(Rgb scene) {
  const Rgb each{film(scene.r), film(scene.g), film(scene.b)};
  const float light = luminance(scene);
  const float scale = light > 0.0F ? film(light) / light : 0.0F;
  const Rgb kept{clamp01(scene.r * scale), clamp01(scene.g * scale), clamp01(scene.b * scale)};
  return mix(each, kept, 0.45F);
}

void write_dithered(uint8_t* pixel, int x, int y, Rgb display) {
  static const EncodingTable encode;
  const uint64_t noise = mix_bits((static_cast<uint64_t>(static_cast<uint32_t>(y)) << 32) | static_cast<uint32_t>(x));
  const std::array<float, 3> channel = {display.r, display.g, display.b};
  for (size_t i = 0; i < 3; ++i) {
    // In [0, 1): what floor() then does is right on average.
    const float dither = static_cast<float>((noise >> (20 * i)) & 0xfffffU) * 0x1p-20F;
    pixel[i] = static_cast<uint8_t>(std::min(encode(channel[i]) * 255.0F + dither, 255.0F));
  }
}

}  // namespace seamount::render
