#include "seamount/server/dry_ground.h"

#include <gtest/gtest.h>

#include "seamount/ops/render/standing_water.h"
#include "seamount/recipe/kinds.h"

namespace seamount::server {
namespace {

/// Land of 20 m, a sea in the west with a coast at `coast`, and a hollow of -80 m with a rim of `rim` cells to the sea.
HeightField terrain_with_hollow(int coast, int rim) {
  HeightField terrain(GridFrame{.width = 60, .height = 48, .cell_m = 10.0}, 20.0F);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < coast; ++x) terrain(x, y) = -30.0F;
    for (int x = coast + rim; x < 50 && y > 8 && y < 40; ++x) terrain(x, y) = -80.0F;
  }
  return terrain;
}

std::string bytes_of(DryGround& ground, const HeightField& terrain, const RasterWindow& window) {
  return ground.bytes("key", recipe::Value::of<recipe::kinds::Terrain>(terrain), window).value_or("none");
}

TEST(DryGround, IsThatOfPictures) {
  const HeightField terrain = terrain_with_hollow(13, 4);
  const Mask expected = render::dry_below_sea(terrain, {}, {});
  DryGround ground;
  const std::string bytes = bytes_of(ground, terrain, {});
  ASSERT_EQ(bytes.size(), terrain.size());
  for (size_t i = 0; i < bytes.size(); ++i) ASSERT_EQ(bytes[i] != 0, expected.data()[i] >= 0.5F) << i;
}

TEST(DryGround, StaysLandUpToItsShoreAtCoarseLevels) {
  const HeightField terrain = terrain_with_hollow(13, 1);  // no cell of level 2 is on the rim
  DryGround ground;
  const std::string bytes = bytes_of(ground, terrain, {.level = 2});
  ASSERT_EQ(bytes.size(), 15U * 12U);
  const auto dry = [&](int x, int y) { return bytes[static_cast<size_t>(y) * 15 + static_cast<size_t>(x)] != 0; };
  EXPECT_TRUE(dry(6, 6));
  EXPECT_TRUE(dry(13, 6)) << "land beside it";
  EXPECT_TRUE(dry(6, 10)) << "land beside it";
  EXPECT_FALSE(dry(3, 6)) << "the sea stays sea";
  EXPECT_FALSE(dry(6, 0));
}

TEST(DryGround, IsAbsentWhereAllWaterIsSea) {
  HeightField terrain = terrain_with_hollow(13, 4);
  DryGround ground;
  EXPECT_EQ(bytes_of(ground, terrain_with_hollow(60, 0), {}), "none");
  for (int y = 20; y < 30; ++y)
    for (int x = 13; x < 17; ++x) terrain(x, y) = -5.0F;  // a strait
  DryGround other;
  EXPECT_EQ(bytes_of(other, terrain, {}), "none");
  EXPECT_EQ(other.bytes("labels", recipe::Value::of<recipe::kinds::Field>(terrain), {}), std::nullopt);
}

}  // namespace
}  // namespace seamount::server
