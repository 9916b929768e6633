#include "seamount/geom/water/incise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "seamount/geom/scalar/noise.h"

namespace seamount::geom {
namespace {

Incised cut(const HeightField& terrain, const Incision& incision) {
  const HeightField filled = fill_depressions(terrain, kNoSea, {});
  const FlowDirections directions = flow_directions(filled, kNoSea, {});
  return incise(terrain, directions, flow_accumulation(directions, {}), incision, {});
}

HeightField rough(int width, int height) {
  HeightField z = fbm_grid(GridFrame::centred(width, height, 20), Seed{3}, {.wavelength_m = 600, .octaves = 5}, {});
  for (float& h : z.cells()) h = 300 * h + 400;
  return z;
}

double sum(const ScalarField& field) { return std::accumulate(field.cells().begin(), field.cells().end(), 0.0); }

TEST(Incise, OneRowIsTheImplicitStepByHand) {
  HeightField ramp(GridFrame::centred(6, 1, 10));
  for (int x = 0; x < 6; ++x) ramp(x, 0) = static_cast<float>(10 * x);
  // All cells of one row lie on the border, where water leaves.
  EXPECT_EQ(cut(ramp, {.rate = 1}).heights, ramp);
  HeightField valley(GridFrame::centred(7, 3, 10), 1000.0F);
  for (int x = 0; x < 7; ++x) valley(x, 1) = static_cast<float>(2 * x);
  const Incised made = cut(valley, {.rate = 0.5F, .deposition = 0});
  float base = 0;
  for (int x = 1; x < 6; ++x) {
    const float rate = 0.5F * std::sqrt(static_cast<float>(6 - x));
    base = (valley(x, 1) + rate * base) / (1 + rate);
    EXPECT_NEAR(made.heights(x, 1), base, 1e-4) << x;
  }
}

TEST(Incise, WhatIsCutIsLaidDownOrLeaves) {
  const HeightField terrain = rough(70, 50);
  for (const float deposition : {0.0F, 1.0F, 4.0F}) {
    const HeightField filled = fill_depressions(terrain, kNoSea, {});
    const FlowDirections directions = flow_directions(filled, kNoSea, {});
    const Incised made = cut(terrain, {.rate = 0.3F, .deposition = deposition});
    double left = 0;
    for (size_t i = 0; i < terrain.size(); ++i) left += directions.data()[i] >= 8 ? made.load.data()[i] : 0.0;
    EXPECT_NEAR(sum(terrain) - sum(made.heights), left, 1e-3 * left + 1) << deposition;
    EXPECT_GT(left, 100) << deposition;
  }
}

TEST(Incise, MoreYearsCutDeeperAndNoneCutNothing) {
  const HeightField terrain = rough(64, 64);
  EXPECT_EQ(cut(terrain, {.rate = 0, .deposition = 0}).heights, terrain);
  double last = 0;
  for (const float rate : {0.01F, 0.1F, 1.0F, 10.0F}) {
    const double lost = sum(terrain) - sum(cut(terrain, {.rate = rate}).heights);
    EXPECT_GT(lost, last) << rate;
    last = lost;
  }
}

TEST(Incise, NoRiseIsSteeperThanTheLimit) {
  HeightField terrain = rough(90, 40);
  const HeightField before = terrain;
  Grid<uint32_t> cells(terrain.frame(), 1);
  cells(40, 20) = 1024;
  limit_rise(terrain, cells, {.steepest = 0.3F, .hollowed = 0.1F}, {});
  int lowered = 0;
  for (int y = 1; y < 39; ++y) {
    for (int x = 1; x < 89; ++x) {
      lowered += terrain(x, y) < before(x, y);
      ASSERT_LE(terrain(x, y), before(x, y));
      for (size_t k = 0; k < 8; ++k) {
        const int u = x + kFlowDx[k], v = y + kFlowDy[k];
        if (terrain.contains(u, v)) {
          ASSERT_LE(terrain(x, y), terrain(u, v) + 0.3F * 20 * kFlowLength[k] + 1.0F) << x << ' ' << y;
        }
      }
    }
  }
  EXPECT_GT(lowered, 200);
  float lowest = terrain(39, 20);
  for (const auto& [u, v] : {std::pair{41, 20}, {40, 19}, {40, 21}}) lowest = std::min(lowest, terrain(u, v));
  EXPECT_LE(terrain(40, 20), lowest + 0.3F * 20 / 2) << "ten doublings";
}

TEST(Incise, FacesOfAPyramidStandAsSteepInAllDirections) {
  const Grid<uint32_t> cells(GridFrame::centred(81, 81, 10), 1);
  HeightField block(cells.frame(), 0.0F);
  for (int y = 20; y <= 60; ++y)
    for (int x = 20; x <= 60; ++x) block(x, y) = 1e4F;
  limit_rise(block, cells, {.steepest = 0.5F}, {});
  for (const int from : {4, 9, 15}) {
    EXPECT_NEAR(block(19 + from, 40), 5 * from, 1e-2);
    EXPECT_NEAR(block(40, 61 - from), 5 * from, 1e-2);
  }
  EXPECT_NEAR(block(40, 40), 5 * 21, 6);
}

}  // namespace
}  // namespace seamount::geom
