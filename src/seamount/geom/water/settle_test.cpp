#include "seamount/geom/water/settle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace seamount::geom {
namespace {

double sum(const ScalarField& field) { return std::accumulate(field.cells().begin(), field.cells().end(), 0.0); }

/// A slope of 1 m a cell that falls to the west, with a lake of 6 x 5 cells, 4 m deep in its middle.
struct Ground {
  HeightField terrain{GridFrame::centred(40, 30, 10)}, filled;
  Ground() {
    for (int y = 0; y < 30; ++y)
      for (int x = 0; x < 40; ++x) terrain(x, y) = static_cast<float>(100 + x);
    for (int y = 10; y < 15; ++y)
      for (int x = 20; x < 26; ++x) terrain(x, y) = x == 22 ? 115.0F : 118.0F;
    filled = fill_depressions(terrain, kNoSea, {});
  }
};

TEST(Settle, ALakeSiltsUpEvenly) {
  const Ground ground;
  Incised made{ground.terrain, ScalarField(ground.terrain.frame(), 0.0F)};
  made.heights(25, 12) += 1.0F;  // where the river came in
  made.heights(24, 12) += 0.5F;
  made.heights(30, 12) -= 3.0F;
  const double before = sum(made.heights);
  settle(ground.terrain, ground.filled, {}, made, {});
  EXPECT_NEAR(sum(made.heights), before, 1e-2);
  EXPECT_EQ(made.heights(30, 12), ground.terrain(30, 12) - 3.0F);
  double room = 0;
  for (size_t i = 0; i < made.heights.size(); ++i) room += ground.filled.data()[i] - ground.terrain.data()[i];
  ASSERT_GT(room, 20);
  for (int y = 10; y < 15; ++y) {
    for (int x = 20; x < 26; ++x) {
      EXPECT_NEAR(made.heights(x, y) - ground.terrain(x, y), 1.5 / room * (ground.filled(x, y) - ground.terrain(x, y)),
                  1e-4);
    }
  }
  // More than there is room for fills it.
  for (int x = 20; x < 26; ++x) made.heights(x, 12) += 50.0F;
  settle(ground.terrain, ground.filled, {}, made, {});
  for (int y = 10; y < 15; ++y)
    for (int x = 20; x < 26; ++x) EXPECT_EQ(made.heights(x, y), ground.filled(x, y));
}

TEST(Settle, WhatReachesTheSeaIsSpreadOverItsFloorAlone) {
  HeightField terrain(GridFrame::centred(80, 60, 50));
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 80; ++x) terrain(x, y) = static_cast<float>(x - 40.5);
  Incised made{terrain, ScalarField(terrain.frame(), 0.0F)};
  made.load(40, 30) = 60.0F;
  made.load(50, 10) = 1000.0F;  // still on its way
  settle(terrain, terrain, {.sea_level_m = 0, .reach_m = 300}, made, {});
  double laid = 0;
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 80; ++x) {
      const float by = made.heights(x, y) - terrain(x, y);
      ASSERT_GE(by, 0);
      if (x > 40) {
        ASSERT_EQ(by, 0);
      }
      ASSERT_LE(made.heights(x, y), std::max(0.0F, terrain(x, y)));
      laid += by;
    }
  }
  EXPECT_NEAR(laid, 60, 6);
  EXPECT_GT(made.heights(38, 30) - terrain(38, 30), 2 * (made.heights(30, 30) - terrain(30, 30)));
  const HeightField kept = made.heights;
  settle(terrain, terrain, {}, made, {});  // no sea, no lake
  EXPECT_EQ(made.heights, kept);
}

}  // namespace
}  // namespace seamount::geom
