#include "seamount/ops/render/subject.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace seamount::render {
namespace {

struct Cone {
  double x, y, radius, peak_m;
};

/// Cones in a sea of 10 km.
HeightField sea_with(const std::vector<Cone>& cones, float floor = -200.0F) {
  HeightField terrain(GridFrame::centred(200, 200, 50.0), floor);
  for (int row = 0; row < 200; ++row)
    for (int column = 0; column < 200; ++column)
      for (const Cone& cone : cones) {
        const double r = std::hypot(terrain.frame().x(column) - cone.x, terrain.frame().y(row) - cone.y);
        terrain(column, row) =
            std::max(terrain(column, row), static_cast<float>(cone.peak_m - (cone.peak_m + 50.0) * r / cone.radius));
      }
  return terrain;
}

struct Box {
  float west, east, south, north;
  bool has(double x, double y) const { return x > west && x < east && y > south && y < north; }
};

Box shown(const HeightField& terrain, double exaggeration = 1.0) {
  const Ground ground(terrain, nullptr, {.exaggeration = exaggeration}, {});
  Box box{1e9F, -1e9F, 1e9F, -1e9F};
  for (const Vec3& place : places_to_show(ground, true, -300.0F)) {
    box = {std::min(box.west, place.x), std::max(box.east, place.x), std::min(box.south, place.y),
           std::max(box.north, place.y)};
  }
  return box;
}

TEST(Subject, AFarIsletIsNotWorthTheSeaBeforeIt) {
  for (const double x : {-2500.0, 0.0, 2000.0}) {
    const Box box = shown(sea_with({{x, -2000, 2200, 700}, {-x, 4400, 180, 30}}));
    EXPECT_TRUE(box.has(x, -2000));
    EXPECT_FALSE(box.has(-x, 4400));
    EXPECT_LT(box.east - box.west, 6000.0F);
  }
}

TEST(Subject, EqualNeighboursAreShownTogether) {
  const Box box = shown(sea_with({{-2500, 0, 1500, 500}, {2500, 500, 1400, 450}, {600, 3000, 1500, 600}}));
  EXPECT_TRUE(box.has(-2500, 0));
  EXPECT_TRUE(box.has(2500, 500));
  EXPECT_TRUE(box.has(600, 3000));
}

TEST(Subject, AReefAroundAnIslandBelongsToIt) {
  // A ring behind a lagoon too deep to be one with the land, in exaggerated pictures too.
  HeightField terrain = sea_with({{500, 300, 1500, 500}});
  for (int row = 0; row < 200; ++row)
    for (int column = 0; column < 200; ++column) {
      const double r = std::hypot(terrain.frame().x(column) - 500.0, terrain.frame().y(row) - 300.0);
      if (std::abs(r - 3600.0) < 120.0) terrain(column, row) = -1.0F;
    }
  for (const double exaggeration : {0.5, 1.0, 3.0}) {
    const Box box = shown(terrain, exaggeration);
    EXPECT_NEAR(box.east, 4100.0F, 250.0F);
    EXPECT_NEAR(box.south, -3300.0F, 250.0F);
  }
}

TEST(Subject, WithoutLandItIsTheReefAndWithoutReefAll) {
  HeightField shelf(GridFrame::centred(200, 200, 50.0), -20.0F);  // all of it a shoal
  for (int row = 20; row < 50; ++row)
    for (int column = 20; column < 60; ++column) shelf(column, row) = -1.5F;
  const Box reef = shown(shelf);
  EXPECT_LT(reef.east, -1500.0F);
  EXPECT_GT(reef.south, 2000.0F);
  const Box all = shown(HeightField(GridFrame::centred(200, 120, 50.0), -300.0F));
  EXPECT_NEAR(all.east - all.west, 9950.0F, 1.0F);
}

TEST(Subject, OddShapes) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 300}, {300, 2}, {129, 131}}) {
    HeightField terrain(GridFrame::centred(width, height, 50.0), -300.0F);
    terrain(width / 2, height / 2) = 100.0F;
    EXPECT_FALSE(places_to_show(Ground(terrain, nullptr, {}, {}), true, 0.0F).empty());
    EXPECT_FALSE(places_to_show(Ground(terrain, nullptr, {}, {}), false, 0.0F).empty());
  }
}

}  // namespace
}  // namespace seamount::render
