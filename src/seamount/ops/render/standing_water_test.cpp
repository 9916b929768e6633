#include "seamount/ops/render/standing_water.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/ops/render/map.h"
#include "seamount/ops/render/perspective.h"
#include "seamount/ops/render/texture.h"

namespace seamount::render {
namespace {

/// Land at 60 m with a sea in the west and a basin at -40 m whose rim is all of the land.
HeightField terrain_with_basin() {
  HeightField terrain(GridFrame::centred(120, 90, 50), 60.0F);
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 120; ++x) {
      if (x < 30) terrain(x, y) = -40.0F;
      if (x >= 60 && x < 100 && y >= 25 && y < 65) terrain(x, y) = -40.0F;
    }
  }
  return terrain;
}

TEST(StandingWater, DryGroundIsTheBasinAndWhatSurroundsIt) {
  const HeightField terrain = terrain_with_basin();
  const Mask dry = dry_below_sea(terrain, {}, {});
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 120; ++x)
      ASSERT_EQ(dry(x, y), x >= 59 && x <= 100 && y >= 24 && y <= 65 ? 1.0F : 0.0F) << x << ' ' << y;
  EXPECT_TRUE(dry_below_sea(terrain, 1e5, {}).empty());
}

TEST(StandingWater, DepthFallsToTheShoreAndBeyond) {
  HeightField terrain(GridFrame::centred(9, 1, 10));
  for (int x = 0; x < 9; ++x) terrain(x, 0) = static_cast<float>(x);
  ScalarField lake(terrain.frame(), 0.0F);
  for (int x = 0; x < 4; ++x) lake(x, 0) = 3.5F - static_cast<float>(x);
  const ScalarField depth = depth_around_lakes(terrain, &lake, {});
  EXPECT_EQ(depth(3, 0), 0.5F);
  EXPECT_EQ(depth(4, 0), -0.5F);
  EXPECT_EQ(depth(6, 0), -kShoreLimit_m);
  raise_to_lakes(terrain, depth);
  for (int x = 0; x < 4; ++x) EXPECT_EQ(terrain(x, 0), 3.5F);
  EXPECT_EQ(terrain(4, 0), 4.0F);
  EXPECT_TRUE(depth_around_lakes(terrain, nullptr, {}).empty());
}

bool is_blue(const Image& image, double x, double y, int least = 15) {
  const auto pixel = image.pixel(static_cast<int>(x * image.width), static_cast<int>(y * image.height));
  return pixel[2] > pixel[0] + least;
}

/// Pixels that look like water, in a view with haze over all of it.
int count_water(const Image& image) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      count += is_blue(image, (x + 0.5) / image.width, (y + 0.5) / image.height, 45) ? 1 : 0;
  return count;
}

TEST(StandingWater, PicturesShowSeaLakesAndDryBasins) {
  const HeightField terrain = terrain_with_basin();
  ScalarField lake(terrain.frame(), 0.0F);
  for (int y = 30; y < 60; ++y)
    for (int x = 65; x < 95; ++x) lake(x, y) = 10.0F;
  const MapParams bare{.width_px = 240, .contours = false, .legend = false, .scale_bar = false, .north_arrow = false};
  const TextureParams small{.size_px = 240};
  for (const bool with_lake : {false, true}) {
    MapDrawings drawings;
    drawings.lake = with_lake ? &lake : nullptr;
    for (const Image& image :
         {map(terrain, nullptr, drawings, bare, {}), texture(terrain, {.lake = drawings.lake}, small, {})}) {
      EXPECT_TRUE(is_blue(image, 0.1, 0.5));
      EXPECT_FALSE(is_blue(image, 0.4, 0.5));
      EXPECT_FALSE(is_blue(image, 0.52, 0.5));
      EXPECT_EQ(is_blue(image, 0.66, 0.5), with_lake);
    }
    PerspectiveParams down{.width_px = 160, .height_px = 120, .haze = 0};
    down.camera.elevation_deg = 70;
    PerspectiveParams flooded = down;
    flooded.min_sea_m2 = 1e5;
    const int wet = count_water(perspective(terrain, {.lake = drawings.lake}, down, {}));
    const int all = count_water(perspective(terrain, nullptr, flooded, {}));
    EXPECT_GT(wet, 500);  // the sea
    EXPECT_LT(wet + (with_lake ? 200 : 600), all);
    if (with_lake) {
      EXPECT_GT(wet, count_water(perspective(terrain, nullptr, down, {})) + 300);
    }
  }
}

}  // namespace
}  // namespace seamount::render
