// terrain.smooth and terrain.terrace.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "seamount/ops/terrain/noise.h"
#include "seamount/ops/terrain/smooth.h"
#include "seamount/ops/terrain/terrace.h"

namespace seamount::terrain {
namespace {

HeightField hills(uint64_t seed, double cell_m = 40.0) {
  return noise({.height_m = 800, .wavelength_m = 2500}, GridFrame::centred(120, 90, cell_m), {seed}, {});
}

double mean(const HeightField& h) {
  return std::accumulate(h.cells().begin(), h.cells().end(), 0.0) / static_cast<double>(h.size());
}

double roughness(const HeightField& h) {
  double sum = 0.0;
  for (int y = 1; y + 1 < h.height(); ++y)
    for (int x = 1; x + 1 < h.width(); ++x)
      sum += std::abs(4.0 * h(x, y) - h(x + 1, y) - h(x - 1, y) - h(x, y + 1) - h(x, y - 1));
  return sum;
}

TEST(Smooth, TakesDetailOffAndKeepsTheMean) {
  for (const uint64_t seed : {1U, 2U, 3U}) {
    const HeightField before = hills(seed);
    double last = roughness(before);
    for (const double radius : {40.0, 80.0, 200.0}) {
      const HeightField after = smooth(before, nullptr, {.radius_m = radius}, {});
      EXPECT_LT(roughness(after), 0.8 * last);
      EXPECT_NEAR(mean(after), mean(before), 1.0);
      last = roughness(after);
    }
    EXPECT_EQ(smooth(before, nullptr, {.strength = 0.0}, {}), before);
    EXPECT_GT(roughness(smooth(before, nullptr, {.strength = -1.0}, {})), 1.2 * roughness(before));
  }
}

TEST(Smooth, OnlyWhereTheMaskSaysSo) {
  const HeightField before = hills(4);
  ScalarField mask(before.frame(), 0.0F);
  for (int y = 0; y < before.height(); ++y)
    for (int x = 60; x < before.width(); ++x) mask(x, y) = x < 80 ? 0.5F : 1.0F;
  const HeightField after = smooth(before, &mask, {}, {}), whole = smooth(before, nullptr, {}, {});
  EXPECT_EQ(after(10, 50), before(10, 50));
  EXPECT_EQ(after(100, 50), whole(100, 50));
  EXPECT_NEAR(after(70, 50), 0.5F * (before(70, 50) + whole(70, 50)), 1e-3F);
}

TEST(Terrace, WhatWasHigherStaysHigherAndNothingMovesByMoreThanAStep) {
  for (const uint64_t seed : {1U, 2U, 3U}) {
    for (const double flatness : {0.0, 0.5, 1.0}) {
      const TerraceParams params{.step_m = 60, .flatness = flatness, .wander_m = 0};
      // A ramp tells the whole curve.
      HeightField ramp(GridFrame::centred(4000, 1, 1.0));
      for (int x = 0; x < 4000; ++x) ramp(x, 0) = -400.0F + 0.2F * static_cast<float>(x);
      const HeightField made = terrace(ramp, nullptr, params, {seed}, {});
      for (int x = 0; x < 4000; ++x) {
        EXPECT_GE(made(x, 0), made(std::max(0, x - 1), 0));
        EXPECT_NEAR(made(x, 0), ramp(x, 0), 1.9F * 60.0F);
        EXPECT_NEAR(made(x, 0), ramp(x, 0), flatness == 0.0 ? 1e-3F : 120.0F);
      }
    }
  }
}

TEST(Terrace, MostGroundBecomesLevelAndAFinerGridIsTheSame) {
  const HeightField coarse = hills(5, 40.0);
  const auto level = [](const HeightField& h) {
    int count = 0;
    for (int y = 0; y < h.height(); ++y)
      for (int x = 0; x + 1 < h.width(); ++x) count += std::abs(h(x + 1, y) - h(x, y)) < 2.0F ? 1 : 0;
    return count;
  };
  const HeightField made = terrace(coarse, nullptr, {.flatness = 1.0}, {7}, {});
  EXPECT_GT(level(made), 2 * level(coarse));
  // Heights of the same place on another grid.
  HeightField one(GridFrame{1, 1, 1.0, coarse.frame().x(30) - 0.5, coarse.frame().y(40) + 0.5, {}}, coarse(30, 40));
  EXPECT_NEAR(terrace(one, nullptr, {.flatness = 1.0, .wander_m = 0}, {7}, {})(0, 0),
              terrace(coarse, nullptr, {.flatness = 1.0, .wander_m = 0}, {7}, {})(30, 40), 1e-3F);
}

}  // namespace
}  // namespace seamount::terrain
