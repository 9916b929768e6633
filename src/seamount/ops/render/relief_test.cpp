#include "seamount/ops/render/relief.h"

#include <gtest/gtest.h>

#include "seamount/ops/render/test_terrain.h"

namespace seamount::render {
namespace {

int brightness(Colour c) { return c.r + c.g + c.b; }

TEST(Relief, LightComesFromTheNorthWest) {
  HeightField cone(GridFrame::centred(101, 101, 10.0));
  for (int y = 0; y < 101; ++y) {
    for (int x = 0; x < 101; ++x) {
      cone(x, y) = 400.0F - 8.0F * std::hypot(static_cast<float>(x) - 50.0F, static_cast<float>(y) - 50.0F);
    }
  }
  ReliefParams params;
  params.width_px = 101;
  const Image image = relief(cone, params, {});
  EXPECT_GT(brightness(image.colour(35, 35)), brightness(image.colour(65, 65)) + 120);
  EXPECT_GT(brightness(image.colour(65, 65)), 180);  // never black
}

TEST(Relief, IsAsWideAsAskedAndKeepsTheShape) {
  const HeightField terrain = test_island(60, 30, 9000.0, 500.0);
  for (const int width : {16, 60, 300}) {
    ReliefParams params;
    params.width_px = width;
    params.tint = ReliefTint::height;
    const Image image = relief(terrain, params, {});
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, width / 2);
  }
}

TEST(Relief, APlainIsEven) {
  const Image image = relief(HeightField(GridFrame::centred(20, 20, 10.0), 7.0F), {.width_px = 40}, {});
  for (size_t i = 0; i < image.rgb.size(); ++i) EXPECT_NEAR(image.rgb[i], image.rgb[i % 3], 2);
}

TEST(Relief, SameBytesForAnyNumberOfThreadsAndOddShapes) {
  const HeightField terrain = test_island(90, 70, 9000.0, 500.0);
  EXPECT_EQ(relief(terrain, {.width_px = 200}, {.threads = 1}), relief(terrain, {.width_px = 200}, {.threads = 2}));
  for (const auto& [w, h] : {std::pair{1, 1}, {1, 5}, {30, 1}}) {
    EXPECT_EQ(relief(HeightField(GridFrame::centred(w, h, 10.0), 3.0F), {.width_px = 16}, {}).width, 16);
  }
}

}  // namespace
}  // namespace seamount::render
