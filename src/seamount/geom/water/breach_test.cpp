// Breaching against the filling of depressions: nothing is left to fill.
#include "seamount/geom/water/breach.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/water/flow.h"

namespace seamount::geom {
namespace {

float deepest_depression(const HeightField& terrain, float sea) {
  const HeightField filled = fill_depressions(terrain, sea, {});
  float deepest = 0.0F;
  for (size_t c = 0; c < filled.size(); ++c) deepest = std::max(deepest, filled.cells()[c] - terrain.cells()[c]);
  return deepest;
}

TEST(Breach, LeavesNoDepressionAndOnlyLowers) {
  for (const uint64_t seed : {1U, 2U, 3U, 4U}) {
    for (const auto& [w, h] : {std::pair{97, 61}, {40, 200}, {3, 3}, {1, 7}, {2, 9}}) {
      HeightField terrain(GridFrame::centred(w, h, 50));
      for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
          terrain(x, y) = static_cast<float>(
              400 * fbm(Seed{seed}, {.wavelength_m = 900}, terrain.frame().x(x), terrain.frame().y(y)));
      const HeightField before = terrain;
      breach_pits(terrain, 0.0F, {}, {});
      EXPECT_EQ(deepest_depression(terrain, 0.0F), 0.0F) << seed << " " << w << "x" << h;
      for (size_t c = 0; c < terrain.size(); ++c) {
        ASSERT_LE(terrain.cells()[c], before.cells()[c]);
        ASSERT_TRUE(before.cells()[c] > 0.0F || terrain.cells()[c] == before.cells()[c]);
      }
    }
  }
}

TEST(Breach, WhatDrainsStaysAsItIs) {
  HeightField cone(GridFrame::centred(60, 60, 10));
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x)
      cone(x, y) = static_cast<float>(300.0 - std::hypot(cone.frame().x(x), cone.frame().y(y)));
  const HeightField before = cone;
  breach_pits(cone, 0.0F, {}, {});
  EXPECT_EQ(cone, before);
}

TEST(Breach, BasinsThatAreMeantStay) {
  HeightField bowl(GridFrame::centred(30, 30, 10), 20.0F);
  Grid<uint8_t> basins(bowl.frame(), 0);
  for (int y = 10; y < 20; ++y)
    for (int x = 10; x < 20; ++x) {
      bowl(x, y) = 5.0F;
      basins(x, y) = 1;
    }
  const HeightField before = bowl;
  breach_pits(bowl, 0.0F, basins, {});
  EXPECT_EQ(bowl, before);
}

TEST(Breach, PlateausAndBowlsOfOneHeightDrain) {
  HeightField bowl(GridFrame::centred(30, 30, 10), 20.0F);
  for (int y = 10; y < 20; ++y)
    for (int x = 10; x < 20; ++x) bowl(x, y) = 5.0F;
  breach_pits(bowl, 0.0F, {}, {});
  EXPECT_EQ(deepest_depression(bowl, 0.0F), 0.0F);
}

}  // namespace
}  // namespace seamount::geom
