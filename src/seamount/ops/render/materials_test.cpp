#include "seamount/ops/render/materials.h"

#include <gtest/gtest.h>

#include "seamount/ops/render/detail_noise.h"

namespace seamount::render {
namespace {

float mean_luminance(SurfacePoint point) {
  float sum = 0.0F;
  for (int i = 0; i < 400; ++i) {
    point.x = 137.0F * static_cast<float>(i % 20);
    point.y = 151.0F * static_cast<float>(i / 20);
    sum += luminance(ground_material(point, {}).albedo) / 400.0F;
  }
  return sum;
}

TEST(Materials, SandIsPaleForestDarkRockBetweenAndSnowWhite) {
  const float beach = mean_luminance({.z = 1.0F, .slope = 0.03F, .shore_m = 20.0F, .labelled = 1.0F, .beach = 1.0F});
  const float forest = mean_luminance({.z = 300.0F, .slope = 0.2F, .concavity = 0.2F});
  const float cliff = mean_luminance({.z = 600.0F, .slope = 2.0F});
  const float snow = mean_luminance({.z = 7000.0F, .slope = 0.1F});
  EXPECT_GT(beach, 2.0F * cliff);
  EXPECT_GT(cliff, 1.2F * forest);
  EXPECT_GT(snow, beach);
}

TEST(Materials, AlbedosArePhysical) {
  for (float z = -3000.0F; z < 8000.0F; z += 37.0F) {
    for (const float slope : {0.0F, 0.4F, 1.5F}) {
      const Rgb a = ground_material({.x = 3.0F * z, .y = z, .z = z, .slope = slope}, {}).albedo;
      for (const float channel : {a.r, a.g, a.b}) {
        EXPECT_GT(channel, 0.0F);
        EXPECT_LT(channel, 1.0F);
      }
    }
  }
}

TEST(Materials, TheWaterLineIsNoSeam) {
  for (float x = 0.0F; x < 2000.0F; x += 61.0F) {
    const Rgb below = ground_material({.x = x, .z = -0.301F, .slope = 0.02F}, {}).albedo;
    const Rgb above = ground_material({.x = x, .z = -0.299F, .slope = 0.02F}, {}).albedo;
    EXPECT_NEAR(below.g, above.g, 0.01F);
  }
}

TEST(DetailNoise, DerivativesMatchDifferences) {
  for (float x = 0.3F; x < 90.0F; x += 3.7F) {
    const float y = 0.7F * x + 2.0F, step = 0.01F;
    const NoiseSample s = detail_noise(5, x, y, 20.0F, 3, 0.5F, 0.1F);
    const float dx = (detail_noise(5, x + step, y, 20.0F, 3, 0.5F, 0.1F).value -
                      detail_noise(5, x - step, y, 20.0F, 3, 0.5F, 0.1F).value) /
                     (2.0F * step);
    const float dy = (detail_noise(5, x, y + step, 20.0F, 3, 0.5F, 0.1F).value -
                      detail_noise(5, x, y - step, 20.0F, 3, 0.5F, 0.1F).value) /
                     (2.0F * step);
    EXPECT_NEAR(s.dx, dx, 2e-3F);
    EXPECT_NEAR(s.dy, dy, 2e-3F);
  }
}

TEST(DetailNoise, VanishesWhereAPixelCoversIt) {
  EXPECT_EQ(detail_noise(5, 1.0F, 2.0F, 20.0F, 3, 0.5F, 15.0F).value, 0.0F);
}

}  // namespace
}  // namespace seamount::render
