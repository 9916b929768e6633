#include "seamount/ops/terrain/noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace seamount::terrain {
namespace {

const GridFrame kFrame = GridFrame::centred(256, 256, 40);

std::vector<double> sorted_slopes_deg(const HeightField& height) {
  std::vector<double> slopes;
  const double cell = height.frame().cell_m;
  for (int y = 1; y < height.height(); ++y) {
    for (int x = 1; x < height.width(); ++x) {
      const double east = (height(x, y) - height(x - 1, y)) / cell, north = (height(x, y) - height(x, y - 1)) / cell;
      slopes.push_back(std::atan(std::hypot(east, north)) * 180 / std::numbers::pi);
    }
  }
  std::sort(slopes.begin(), slopes.end());
  return slopes;
}

/// Within what eighteen 10 km squares of the Alps (46 N 8 E) and Apennines (42 N 12 E) show on cells of 90 m:
/// hypsometric integral 0.15 to 0.56, median slope 4 to 33 degrees, 1 % steeper than 18 to 55 degrees.
TEST(Noise, TheDefaultIsLandLikeRealMountains) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const HeightField height = noise({}, GridFrame::centred(113, 113, 90), Seed{seed}, {});
    const auto cells = height.cells();
    const auto water = std::count_if(cells.begin(), cells.end(), [](float z) { return z < 0; });
    EXPECT_LE(static_cast<double>(water), 0.1 * static_cast<double>(cells.size())) << seed;
    const auto [low, high] = std::minmax_element(cells.begin(), cells.end());
    double sum = 0;
    for (const float z : cells) sum += z;
    const double integral = (sum / static_cast<double>(cells.size()) - *low) / (*high - *low);
    EXPECT_GT(integral, 0.15) << seed;
    EXPECT_LT(integral, 0.56) << seed;
    EXPECT_GT(*high - *low, 600) << seed;
    const std::vector<double> slopes = sorted_slopes_deg(height);
    EXPECT_GT(slopes[slopes.size() / 2], 4) << seed;
    EXPECT_LT(slopes[slopes.size() / 2], 33) << seed;
    EXPECT_GT(slopes[slopes.size() * 99 / 100], 18) << seed;
    EXPECT_LT(slopes[slopes.size() * 99 / 100], 55) << seed;
  }
}

TEST(Noise, NoHeightIsLevelForEachKind) {
  for (const NoiseKind kind : {NoiseKind::smooth, NoiseKind::ridged, NoiseKind::mountains}) {
    const HeightField level = noise({.kind = kind, .height_m = 0, .base_m = -20}, kFrame, Seed{1}, {});
    for (const float z : level.cells()) ASSERT_EQ(z, -20.0F);
  }
}

TEST(Noise, HeightsThatAreNotStatedFollowTheKind) {
  const auto same = [](const NoiseParams& a, const NoiseParams& b) {
    const HeightField one = noise(a, kFrame, Seed{3}, {}), other = noise(b, kFrame, Seed{3}, {});
    return std::equal(one.cells().begin(), one.cells().end(), other.cells().begin());
  };
  EXPECT_TRUE(same({.kind = NoiseKind::smooth}, {.kind = NoiseKind::smooth, .height_m = 400}));
  EXPECT_TRUE(same({.wavelength_m = 8000}, {.height_m = 2000, .wavelength_m = 8000}));
  EXPECT_FALSE(same({.wavelength_m = 8000}, {.height_m = 400, .wavelength_m = 8000}));
}

TEST(Noise, CoarseMountainsAreAPreviewOfFineOnes) {
  const HeightField fine = noise({}, kFrame, Seed{2}, {});
  const HeightField coarse = noise({}, GridFrame::centred(128, 128, 80), Seed{2}, {});
  double squares = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      const double mean =
          0.25 * (fine(2 * x, 2 * y) + fine(2 * x + 1, 2 * y) + fine(2 * x, 2 * y + 1) + fine(2 * x + 1, 2 * y + 1));
      squares += (mean - coarse(x, y)) * (mean - coarse(x, y));
    }
  }
  EXPECT_LT(std::sqrt(squares / (128 * 128)), 40) << "of about a thousand metres";
}

}  // namespace
}  // namespace seamount::terrain
