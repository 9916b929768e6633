#include "seamount/ops/classify/belt.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/ops/classify/terrain.h"

namespace seamount::classify {
namespace {

/// A coast in the west, a shelf 35 m deep to 70 km, the deep beyond; at 50 km reefs of 3 km that are `apart_m` from one
/// another from middle to middle (0: none).
HeightField shelf(double apart_m, double width_m = 100e3) {
  HeightField terrain(GridFrame::centred(static_cast<int>(width_m / 500), 240, 500));
  for (int y = 0; y < terrain.height(); ++y) {
    for (int x = 0; x < terrain.width(); ++x) {
      const double from_coast = 500.0 * x - 5000.0, along = 500.0 * y;
      double z = from_coast < 0 ? 50.0 : from_coast < 70e3 ? -std::min(35.0, 5.0 + 0.01 * from_coast) : -1500.0;
      if (apart_m > 0 && std::abs(from_coast - 50e3) < 1500 && std::abs(std::remainder(along, apart_m)) < 1500)
        z = -1.0;
      terrain(x, y) = static_cast<float>(z);
    }
  }
  return terrain;
}

/// Share of the water at a distance from the coast that has a label, away from the frame's edges in the north and
/// south.
double share(const LabelMap& labels, double from_coast_m, Region region) {
  const int x = static_cast<int>((from_coast_m + 5000.0) / 500);
  int count = 0;
  for (int y = 60; y < 180; ++y) count += labels(x, y) == region ? 1 : 0;
  return count / 120.0;
}

TEST(Belt, WhatLiesBehindItIsLagoon) {
  for (const double apart_m : {8e3, 15e3, 22e3}) {
    const LabelMap labels = terrain(shelf(apart_m), {}, {}).labels;
    EXPECT_GT(share(labels, 10e3, Region::lagoon), 0.95) << apart_m;
    EXPECT_GT(share(labels, 25e3, Region::lagoon), 0.95) << apart_m;
    EXPECT_GT(share(labels, 45e3, Region::lagoon), 0.95) << apart_m;
    EXPECT_LT(share(labels, 62e3, Region::lagoon), 0.05) << apart_m;  // in front of the belt
    EXPECT_EQ(share(labels, 80e3, Region::abyss), 1.0) << apart_m;
  }
}

TEST(Belt, AnOpenShelfAndReefsFarApartAreNone) {
  for (const double apart_m : {0.0, 40e3}) {
    const LabelMap labels = terrain(shelf(apart_m), {}, {}).labels;
    EXPECT_LT(share(labels, 25e3, Region::lagoon), 0.1) << apart_m;
  }
  EXPECT_LT(share(terrain(shelf(15e3), {.belt_gap_m = 5000}, {}).labels, 25e3, Region::lagoon), 0.3);
}

TEST(Belt, WithoutADeepThereIsNoBehind) {
  const Grid<uint8_t> behind = behind_belt(shelf(8e3, 70e3), {}, {});
  for (int y = 60; y < 180; ++y) EXPECT_EQ(behind(135, y), 0);  // between the reefs and the frame's edge
}

TEST(Belt, CoastsAreNotLinkedAndLinksKeepToThePlatform) {
  // Two islands of 10 km, 6 km apart on a platform: the strait between them is open at both ends.
  HeightField terrain(GridFrame::centred(160, 160, 500), -40.0F);
  for (int y = 0; y < 160; ++y) {
    for (int x = 0; x < 160; ++x) {
      const double away = std::min(std::hypot(x - 64, y - 80), std::hypot(x - 96, y - 80));
      if (away < 10) terrain(x, y) = 60.0F;
      if (away > 40) terrain(x, y) = -900.0F;
    }
  }
  EXPECT_EQ(behind_belt(terrain, {}, {})(80, 80), 0);
  // Reefs that the deep parts are no belt.
  HeightField reefs = shelf(15e3);
  for (int y = 0; y < reefs.height(); ++y)
    for (int x = 0; x < reefs.width(); ++x)
      if (std::abs(std::remainder(500.0 * y - 7500.0, 15e3)) < 2000) reefs(x, y) = std::min(reefs(x, y), -900.0F);
  const Grid<uint8_t> behind = behind_belt(reefs, {}, {});
  int count = 0;
  for (int y = 60; y < 180; ++y) count += behind(70, y);
  EXPECT_LT(count, 20);
}

TEST(Belt, OddShapes) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 30}, {30, 1}, {2, 2}}) {
    const Grid<uint8_t> behind = behind_belt(HeightField(GridFrame::centred(width, height, 50.0), -3.0F), {}, {});
    for (const uint8_t cell : behind.cells()) EXPECT_EQ(cell, 0);
  }
}

}  // namespace
}  // namespace seamount::classify
