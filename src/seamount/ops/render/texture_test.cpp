#include "seamount/ops/render/texture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/error.h"
#include "seamount/ops/render/test_terrain.h"

namespace seamount::render {
namespace {

TEST(Texture, HasTheTerrainsShape) {
  const HeightField wide = test_island(80, 40, 8000.0, 400.0);
  const Image image = texture(wide, nullptr, {.size_px = 128}, {});
  EXPECT_EQ(image.width, 128);
  EXPECT_EQ(image.height, 64);
  EXPECT_EQ(texture(HeightField(GridFrame::centred(1, 1, 10.0), 5.0F), nullptr, {.size_px = 1}, {}).width, 1);
}

TEST(Texture, DeepSeaIsBlueUnderWaterAndBareWithout) {
  const HeightField deep(GridFrame::centred(16, 16, 50.0), -900.0F);
  const Colour wet = texture(deep, nullptr, {.size_px = 16}, {}).colour(8, 8);
  EXPECT_GT(wet.b, wet.r + 30);
  const Colour bare = texture(deep, nullptr, {.size_px = 16, .water = false}, {}).colour(8, 8);
  EXPECT_GE(bare.r + 10, bare.b);
}

TEST(Texture, GreensAreMuted) {
  const HeightField terrain = test_island(200, 200, 20000.0, 1200.0);
  const Image image = texture(terrain, nullptr, {.size_px = 200}, {});
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      if (terrain(x, y) < 5.0F) continue;
      const Colour c = image.colour(x, y);
      EXPECT_LE(c.g, 1.45 * c.r + 12.0);
    }
  }
}

TEST(Texture, SnowStaysOnTheSideThatTheSunDoesNotReach) {
  HeightField ridge(GridFrame::centred(128, 128, 50.0));  // from west to east
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) ridge(x, y) = 2700.0F - 0.5F * static_cast<float>(std::abs(ridge.frame().y(y)));
  const auto whiter_in_the_north = [&](double latitude) {
    TextureParams params{.size_px = 128, .baked_light = 0.0, .snow_line_m = 2000.0};
    params.climate.latitude_deg = latitude;
    params.climate.wind_from_deg = 270;
    const Image image = texture(ridge, nullptr, params, {});
    double sum = 0;
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 128; ++x) sum += (y < 64 ? 1 : -1) * static_cast<int>(image.pixel(x, y)[2]);
    return sum / (64 * 128);
  };
  EXPECT_GT(whiter_in_the_north(46), 8);
  EXPECT_LT(whiter_in_the_north(-46), -8);
}

TEST(Texture, LabelsTurnGroundToReefAndSand) {
  const HeightField floor(GridFrame::centred(32, 32, 20.0), -6.0F);
  const LabelMap lagoon(floor.frame(), Region::lagoon), abyss(floor.frame(), Region::abyss);
  const auto mean = [&](const LabelMap& labels) {
    double sum = 0.0;
    const Image image = texture(floor, &labels, {.size_px = 32}, {});
    for (const uint8_t v : image.rgb) sum += v;
    return sum;
  };
  EXPECT_GE(mean(lagoon), mean(abyss));
  const LabelMap wrong(GridFrame::centred(31, 32, 20.0), Region::reef);
  EXPECT_THROW(texture(floor, &wrong, {.size_px = 32}, {}), IncompatibleInputs);
}

TEST(Texture, SameBytesForAnyNumberOfThreads) {
  const HeightField terrain = test_island(90, 70, 9000.0, 500.0);
  EXPECT_EQ(texture(terrain, nullptr, {.size_px = 300}, {.threads = 1}),
            texture(terrain, nullptr, {.size_px = 300}, {.threads = 2}));
}

}  // namespace
}  // namespace seamount::render
