#include "seamount/ops/render/style.h"

#include <gtest/gtest.h>

#include "seamount/ops/render/lava.h"
#include "seamount/ops/render/map.h"
#include "seamount/ops/render/test_terrain.h"
#include "seamount/ops/render/texture.h"

namespace seamount::render {
namespace {

constexpr std::array kStyles = {Style::great_barrier_reef, Style::stone, Style::desert, Style::volcano};

TEST(Style, BordersAreDepthsOfTheReefAndSharesOfTheLandOtherwise) {
  HeightField terrain(GridFrame::centred(2, 1, 10.0));
  terrain(0, 0) = -300.0F;
  terrain(1, 0) = 1000.0F;
  const geom::Borders stone = style_borders(Style::stone, {}, terrain);
  EXPECT_DOUBLE_EQ(stone.low_m, 300);
  EXPECT_DOUBLE_EQ(stone.high_m, 500);
  EXPECT_DOUBLE_EQ(stone.low_error_m, 100);
  EXPECT_DOUBLE_EQ(style_borders(Style::stone, {.low_m = 50}, terrain).low_m, 50);
  const geom::Borders reef = style_borders(Style::great_barrier_reef, {}, terrain);
  EXPECT_LT(reef.low_m, -20);
  EXPECT_GT(reef.high_m, -10);
  EXPECT_LT(reef.high_m, 0);
}

TEST(Style, AlbedosArePhysicalAndOnlyLavaGlows) {
  for (const Style style : kStyles) {
    for (float z = -400.0F; z < 3000.0F; z += 17.0F) {
      for (const float share : {0.0F, 0.5F, 1.0F}) {
        const SurfacePoint point{
            .x = 3.0F * z, .y = z, .z = z, .slope = share, .low = share, .high = 0.5F - 0.5F * share};
        const Material material = ground_material(point, {.style = style});
        for (const float channel : {material.albedo.r, material.albedo.g, material.albedo.b}) {
          ASSERT_GT(channel, 0.0F);
          ASSERT_LT(channel, 1.0F);
        }
        ASSERT_TRUE(style == Style::volcano || material.glow == Rgb{});
      }
    }
  }
  const Material lava = ground_material({.z = 500.0F, .lava = 1.0F}, {.style = Style::volcano});
  EXPECT_GT(lava.glow.r, 0.5F);
  EXPECT_GT(lava.glow.r, lava.glow.g);
  EXPECT_GT(lava.glow.g, lava.glow.b);
}

TEST(Style, TexturesAndMapsDifferBetweenStylesAndNaturalIsTheDefault) {
  const HeightField terrain = test_island(96, 96, 12000.0, 900.0);
  std::vector<Image> textures = {texture(terrain, nullptr, {.size_px = 96}, {})};
  std::vector<Image> maps = {map(terrain, nullptr, {.width_px = 200}, {})};
  EXPECT_EQ(texture(terrain, nullptr, {.size_px = 96, .style = Style::natural, .layers = {.variation = 1}}, {}),
            textures[0]);
  for (const Style style : kStyles) {
    textures.push_back(texture(terrain, nullptr, {.size_px = 96, .style = style}, {.threads = 1}));
    EXPECT_EQ(textures.back(), texture(terrain, nullptr, {.size_px = 96, .style = style}, {.threads = 3}));
    maps.push_back(map(terrain, nullptr, {.width_px = 200, .style = style}, {}));
  }
  for (size_t i = 0; i < textures.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      EXPECT_NE(textures[i], textures[j]);
      EXPECT_NE(maps[i], maps[j]);
    }
  }
  EXPECT_THROW(texture(terrain, nullptr, {.style = Style::stone, .layers = {.low_m = 500, .high_m = 100}}, {}),
               InvalidArgument);
  EXPECT_THROW(map(terrain, nullptr, {.style = Style::stone, .layers = {.variation = 3}}, {}), InvalidArgument);
}

TEST(Lava, RunsDownFromTheVentsAndGrowsCold) {
  HeightField cone(GridFrame::centred(200, 200, 20.0));
  Mask vents(cone.frame());
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      const auto r = static_cast<float>(std::hypot(cone.frame().x(x), cone.frame().y(y)));
      cone(x, y) = 900.0F - 0.5F * r;
      vents(x, y) = cone(x, y) > 600.0F ? 1.0F : 0.0F;
    }
  }
  const Mask lava = lava_streams(cone, vents, {400, 50, 600, 30}, {});
  double above = 0, between = 0, below = 0;
  for (size_t i = 0; i < lava.size(); ++i) {
    ASSERT_GE(lava.cells()[i], 0.0F);
    ASSERT_LE(lava.cells()[i], 1.0F);
    (cone.cells()[i] > 600.0F ? above : cone.cells()[i] > 300.0F ? between : below) += lava.cells()[i];
  }
  EXPECT_GT(between, 50.0);
  EXPECT_LT(below, 0.2 * between);
  EXPECT_GT(above, 0.0);
  EXPECT_EQ(lava_streams(cone, Mask(cone.frame(), 0.0F), {400, 50, 600, 30}, {}), Mask(cone.frame(), 0.0F));
}

}  // namespace
}  // namespace seamount::render
