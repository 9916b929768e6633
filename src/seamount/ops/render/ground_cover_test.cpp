#include "seamount/ops/render/ground_cover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "seamount/ops/render/test_terrain.h"

namespace seamount::render {
namespace {

/// A round mountain in the sea.
HeightField mountain(double height_m) {
  HeightField terrain(GridFrame::centred(160, 160, 100.0));
  for (int y = 0; y < 160; ++y)
    for (int x = 0; x < 160; ++x) {
      const double r = std::hypot(terrain.frame().x(x), terrain.frame().y(y));
      terrain(x, y) = static_cast<float>(height_m * (1.0 - r / 6000.0));
    }
  return terrain;
}

TEST(GroundCover, WindwardSidesAreWetterThanLeewardOnes) {
  const HeightField terrain = mountain(1500.0);
  for (double from = 0.0; from < 2.0 * std::numbers::pi; from += 0.7) {
    const Grid<CoverTexel> cover = ground_cover(terrain, {}, nullptr, 1.0, from, {});
    const auto rain = [&](double side) {
      const auto x = static_cast<int>(std::lround(79.5 + side * 30.0 * std::sin(from)));
      const auto y = static_cast<int>(std::lround(79.5 - side * 30.0 * std::cos(from)));
      return cover(x, y).rain;
    };
    EXPECT_GT(rain(1.0), 2.0F * rain(-1.0)) << from;
    double sum = 0.0, land = 0.0;
    for (int y = 0; y < 160; ++y)
      for (int x = 0; x < 160; ++x)
        if (terrain(x, y) > 0.0F) {
          sum += cover(x, y).rain;
          land += 1.0;
        }
    EXPECT_NEAR(sum / land, 1.0, 0.05);  // shares of the mean
  }
}

TEST(GroundCover, ALowIslandHasNoLee) {
  const Grid<CoverTexel> cover = ground_cover(mountain(60.0), {}, nullptr, 1.0, 1.0, {});
  for (int y = 50; y < 110; ++y)
    for (int x = 50; x < 110; ++x) EXPECT_NEAR(cover(x, y).rain, 1.0F, 0.2F);
}

TEST(GroundCover, WaterGathersInValleys) {
  // A gutter along the middle column.
  HeightField terrain(GridFrame::centred(121, 121, 30.0));
  for (int y = 0; y < 121; ++y)
    for (int x = 0; x < 121; ++x)
      terrain(x, y) =
          100.0F + 0.3F * 30.0F * static_cast<float>(std::abs(x - 60)) - 0.02F * 30.0F * static_cast<float>(y);
  const Grid<CoverTexel> cover = ground_cover(terrain, {}, nullptr, 1.0, 0.0, {});
  for (int y = 60; y < 110; ++y) {
    EXPECT_GT(cover(60, y).wet, 0.4F);
    EXPECT_LT(cover(30, y).wet, 0.4F * cover(60, y).wet);
  }
}

TEST(GroundCover, TheShoreIsAsFarAsItIs) {
  HeightField terrain(GridFrame::centred(60, 40, 50.0));
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x) terrain(x, y) = x < 20 ? -10.0F : 10.0F;
  const Grid<CoverTexel> cover = ground_cover(terrain, {}, nullptr, 1.0, 0.0, {});
  for (int x = 0; x < 60; ++x) EXPECT_EQ(cover(x, 7).shore_m, 50.0F * static_cast<float>(x < 20 ? 20 - x : x - 19));
}

TEST(GroundCover, SameForAnyNumberOfThreads) {
  const HeightField terrain = test_island(300, 260, 9000.0, 900.0);
  const Grid<CoverTexel> one = ground_cover(terrain, {}, nullptr, 2.0, 1.0, {.threads = 1}),
                         four = ground_cover(terrain, {}, nullptr, 2.0, 1.0, {.threads = 4});
  for (size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one.data()[i].rain, four.data()[i].rain);
    EXPECT_EQ(one.data()[i].wet, four.data()[i].wet);
    EXPECT_EQ(one.data()[i].sky, four.data()[i].sky);
  }
}

}  // namespace
}  // namespace seamount::render
