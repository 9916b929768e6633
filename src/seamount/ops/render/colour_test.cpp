#include "seamount/ops/render/colour.h"

#include <gtest/gtest.h>

#include <array>

namespace seamount::render {
namespace {

TEST(Colour, EverySrgbByteSurvivesTheWayToLinearLightAndBack) {
  for (int v = 0; v < 256; ++v) {
    const auto byte = static_cast<unsigned char>(v);
    EXPECT_EQ(srgb(linear(Colour{byte, 0, byte})), (Colour{byte, 0, byte}));
  }
  EXPECT_NEAR(linear_from_srgb(0.5F), 0.21404F, 1e-5F);  // IEC 61966-2-1
}

TEST(Colour, PerceptualMixesKeepTheirEndsAndStepLightnessEvenly) {
  const Rgb a = linear({230, 232, 206}), b = linear({27, 58, 101});
  EXPECT_EQ(srgb(mix_perceptual(a, b, 0.0F)), srgb(a));
  EXPECT_EQ(srgb(mix_perceptual(a, b, 1.0F)), srgb(b));
  const float middle = lightness(mix_perceptual(a, b, 0.5F));
  EXPECT_NEAR(middle, 0.5F * (lightness(a) + lightness(b)), 1e-3F);
}

TEST(Colour, ToneCurveRisesFromBlackAndStaysBelowWhite) {
  float previous = -1.0F;
  for (float x = 0.0F; x < 20.0F; x += 0.01F) {
    const Rgb c = tone_curve({x, x, x});
    EXPECT_GE(c.g, previous - 1e-6F);
    EXPECT_LE(c.g, 1.0F + 1e-6F);
    EXPECT_FLOAT_EQ(c.r, c.b);
    previous = c.g;
  }
  EXPECT_EQ(tone_curve({}), Rgb{});
}

TEST(Colour, DitherKeepsTheMeanBetweenTwoSteps) {
  // A grey between two 8-bit values: the mean over many pixels must give it back.
  const float grey = linear_from_srgb(100.3F / 255.0F);
  double sum = 0.0;
  constexpr int kSide = 128;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      std::array<uint8_t, 3> pixel{};
      write_dithered(pixel.data(), x, y, {grey, grey, grey});
      EXPECT_NEAR(pixel[0], 100.3, 1.31);
      sum += pixel[0];
    }
  }
  EXPECT_NEAR(sum / (kSide * kSide), 100.3, 0.03);
}

}  // namespace
}  // namespace seamount::render
