#include "seamount/ops/render/water.h"

#include <gtest/gtest.h>

namespace seamount::render {
namespace {

constexpr Rgb kSand{0.55F, 0.48F, 0.36F};

WaterPoint at_depth(float depth) {
  WaterPoint point;
  point.to_eye = normalised({0.0F, -1.0F, 0.6F});
  point.depth = depth;
  point.floor = kSand;
  return point;
}

TEST(Water, RedLightIsLostFirstAndBlueLast) {
  const Rgb through = water_transmittance(20.0F, 1.0F);
  EXPECT_LT(through.r, through.g);
  EXPECT_LT(through.g, through.b);
  EXPECT_FLOAT_EQ(water_transmittance(0.0F, 1.0F).r, 1.0F);
  EXPECT_NEAR(water_transmittance(20.0F, 2.0F).g, water_transmittance(10.0F, 1.0F).g, 1e-6F);
}

TEST(Water, LagoonsAreTurquoiseAndTheAbyssIsDarkBlue) {
  const Sky sky({4.9, 0.6});
  const Rgb lagoon = water_light(at_depth(8.0F), sky, 1.0F), abyss = water_light(at_depth(3000.0F), sky, 1.0F);
  EXPECT_GT(lagoon.g, 2.0F * lagoon.r);
  EXPECT_GT(lagoon.b, 2.0F * lagoon.r);
  EXPECT_NEAR(lagoon.g / lagoon.b, 1.0F, 0.25F);
  EXPECT_GT(abyss.b, 1.5F * abyss.g);
  EXPECT_GT(luminance(lagoon), 2.5F * luminance(abyss));
}

TEST(Water, DeeperIsDarkerAndEndsAtOneColour) {
  const Sky sky({4.9, 0.6});
  float previous = 10.0F;
  for (float depth = 5.0F; depth < 400.0F; depth += 5.0F) {
    const float l = luminance(water_light(at_depth(depth), sky, 1.0F));
    EXPECT_LE(l, previous + 1e-4F);
    previous = l;
  }
  EXPECT_NEAR(previous, luminance(water_light(at_depth(5000.0F), sky, 1.0F)), 1e-4F);
}

TEST(Water, TheSunsRoadIsWideAndNeverWhite) {
  const Vec3 up{0.0F, 0.0F, 1.0F};
  for (const float elevation : {0.05F, 0.2F, 0.5F, 1.0F, 1.5F}) {
    const Vec3 sun{0.0F, std::cos(elevation), std::sin(elevation)};
    for (const float variance : {0.003F, 0.012F, 0.034F, 0.06F}) {
      for (float eye = 0.01F; eye < 1.5F; eye += 0.05F) {
        const float glint = sun_glint({0.0F, -std::cos(eye), std::sin(eye)}, up, sun, variance);
        EXPECT_GE(glint, 0.0F);
        EXPECT_LE(glint, 0.36F);
      }
    }
    // Beside the mirror's place there is still light, the more the rougher the sea.
    if (elevation < 0.4F) continue;
    const auto beside = [&](float variance, float by) {
      return sun_glint(normalised({std::sin(by), -std::cos(elevation), std::sin(elevation)}), up, sun, variance);
    };
    EXPECT_GT(beside(0.034F, 0.15F), 0.3F * beside(0.034F, 0.0F));
    EXPECT_GT(beside(0.034F, 0.4F), beside(0.004F, 0.4F));
  }
}

TEST(Water, RefractionFollowsSnell) {
  EXPECT_FLOAT_EQ(refracted_cosine(1.0F), 1.0F);
  EXPECT_NEAR(std::sqrt(1.0F - refracted_cosine(0.0F) * refracted_cosine(0.0F)), 1.0F / 1.333F, 1e-5F);
}

TEST(Water, FoamStaysInTheShallows) {
  for (float x = 0.0F; x < 500.0F; x += 7.0F) {
    EXPECT_EQ(foam_share(x, 30.0F, 5.0F, 12.0F, 1.0F, 1.0F), 0.0F);
    EXPECT_LE(foam_share(x, 30.0F, 5.0F, 0.5F, 1.0F, 1.0F), 1.0F);
  }
}

}  // namespace
}  // namespace seamount::render
