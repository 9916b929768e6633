#include "seamount/geom/grid/height_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::geom {
namespace {

// The paper's own numbers on normalised heights (P4 sec. 3.4).
constexpr Borders kPaper{0.3, 0.1, 0.5, 0.05};

TEST(HeightLayers, ErrorPassIsEquation5) {
  EXPECT_EQ(error_pass(0, 0.1), 1);
  EXPECT_DOUBLE_EQ(error_pass(0.025, 0.1), 0.75);
  EXPECT_EQ(error_pass(0.1, 0.1), 0);
  EXPECT_EQ(error_pass(5, 0.1), 0);
  EXPECT_EQ(error_pass(0, 0), 0);
}

TEST(HeightLayers, LowAndHighPassAreEquations3And4) {
  EXPECT_EQ(low_pass(-1, 0.3, 0.1), 1);
  EXPECT_EQ(low_pass(0.3, 0.3, 0.1), 1);
  EXPECT_NEAR(low_pass(0.34, 0.3, 0.1), 0.6, 1e-12);
  EXPECT_EQ(low_pass(0.41, 0.3, 0.1), 0);
  EXPECT_EQ(high_pass(0.7, 0.5, 0.05), 1);
  EXPECT_EQ(high_pass(0.5, 0.5, 0.05), 1);
  EXPECT_NEAR(high_pass(0.46, 0.5, 0.05), 0.2, 1e-12);
  EXPECT_EQ(high_pass(0.44, 0.5, 0.05), 0);
}

TEST(HeightLayers, SharesAreEquation6WithThePapersNumbers) {
  const auto is = [](double h, double low, double middle, double high) {
    const LayerShares s = layer_shares(h, kPaper);
    EXPECT_NEAR(s.low, low, 1e-12) << h;
    EXPECT_NEAR(s.middle, middle, 1e-12) << h;
    EXPECT_NEAR(s.high, high, 1e-12) << h;
  };
  is(0.0, 1, 0, 0);
  is(0.3, 1, 0, 0);
  is(0.35, 0.5, 0.5, 0);
  is(0.42, 0, 1, 0);
  is(0.475, 0, 0.5, 0.5);
  is(0.5, 0, 0, 1);
  is(1.0, 0, 0, 1);
  // Borders so close that all three meet: eq. 6 gives low the first say.
  const LayerShares s = layer_shares(0.34, {0.3, 0.1, 0.35, 0.05});
  EXPECT_NEAR(s.low, 0.6, 1e-12);
  EXPECT_NEAR(s.high, 0.4 * 0.8, 1e-12);
  EXPECT_NEAR(s.low + s.middle + s.high, 1, 1e-12);
}

TEST(HeightLayers, BordersThatAreAbsentAreSharesOfTheRelief) {
  const Borders b = resolve_borders({}, -100, 400);
  EXPECT_DOUBLE_EQ(b.low_m, 50);
  EXPECT_DOUBLE_EQ(b.low_error_m, 50);
  EXPECT_DOUBLE_EQ(b.high_m, 150);
  EXPECT_DOUBLE_EQ(b.high_error_m, 25);
  EXPECT_DOUBLE_EQ(resolve_borders({.high_m = 300}, -100, 400).high_m, 300);
  EXPECT_THROW(resolve_borders({.low_m = 200}, -100, 400), InvalidArgument);
}

TEST(HeightLayers, ReliefCountsFromTheSeaWhereThereIsLandAndSea) {
  HeightField ground(GridFrame::centred(3, 1, 10.0));
  const auto borders = [&](float a, float b, float c) {
    ground(0, 0) = a, ground(1, 0) = b, ground(2, 0) = c;
    return relief_borders({}, ground);
  };
  EXPECT_DOUBLE_EQ(borders(-4000, 10, 1000).low_m, 300);
  EXPECT_DOUBLE_EQ(borders(-9, 10, 1000).high_m, 500);
  EXPECT_DOUBLE_EQ(borders(200, 700, 1200).low_m, 500);
  EXPECT_DOUBLE_EQ(borders(-400, -300, -200).high_m, -300);
}

HeightField hills(int width, int height) {
  HeightField terrain = fbm_grid(GridFrame::centred(width, height, 25.0), Seed{8}, {.wavelength_m = 1500}, {});
  for (float& z : terrain.cells()) z = 200.0F + 200.0F * z;
  return terrain;
}

const Borders kMetres{150, 40, 250, 20};

TEST(HeightLayers, PlainLayersAreEquation6OnEveryCell) {
  const HeightField terrain = hills(70, 50);
  const Layers linear = height_layers(terrain, kMetres, false, 0.0, {});
  const Layers smooth = height_layers(terrain, kMetres, true, 0.0, {});
  for (size_t i = 0; i < terrain.size(); ++i) {
    const double h = terrain.cells()[i];
    const LayerShares s = layer_shares(h, kMetres);
    ASSERT_NEAR(linear.low.cells()[i], s.low, 1e-5);
    ASSERT_NEAR(linear.middle.cells()[i], s.middle, 1e-5);
    ASSERT_NEAR(linear.high.cells()[i], s.high, 1e-5);
    const double low = smoothstep(low_pass(h, 150, 40)), high = smoothstep(high_pass(h, 250, 20));
    ASSERT_NEAR(smooth.low.cells()[i], low, 1e-5);
    ASSERT_NEAR(smooth.high.cells()[i], (1 - low) * high, 1e-5);
  }
}

TEST(HeightLayers, SumToOneHoweverVaried) {
  for (const auto& [width, height] : {std::pair{90, 60}, {1, 1}, {1, 20}, {20, 1}}) {
    for (const double error : {0.0, 30.0}) {
      const Layers layers = height_layers(hills(width, height), {180, error, 230, error}, true, 1.0, {});
      for (size_t i = 0; i < layers.low.size(); ++i) {
        const float low = layers.low.cells()[i], middle = layers.middle.cells()[i], high = layers.high.cells()[i];
        ASSERT_NEAR(low + middle + high, 1.0F, 1e-6);
        ASSERT_GE(std::min({low, middle, high}), 0.0F);
      }
    }
  }
}

TEST(HeightLayers, VariationBreaksBandsButKeepsLayersNearTheirHeights) {
  const HeightField terrain = hills(300, 300);
  const Layers plain = height_layers(terrain, kMetres, true, 0.0, {});
  const Layers varied = height_layers(terrain, kMetres, true, 1.0, {});
  double difference = 0;
  for (size_t i = 0; i < terrain.size(); ++i) {
    difference += std::abs(plain.low.cells()[i] - varied.low.cells()[i]);
    ASSERT_TRUE(terrain.cells()[i] > 150 - 260 || varied.low.cells()[i] == 1.0F);
    ASSERT_TRUE(terrain.cells()[i] < 250 + 220 || varied.high.cells()[i] == 1.0F);
  }
  difference /= static_cast<double>(terrain.size());
  EXPECT_GT(difference, 0.03);
  EXPECT_LT(difference, 0.3);
}

TEST(HeightLayers, SteepGroundIsMoreOfTheMiddleLayer) {
  const auto mean_middle = [](float slope) {
    // Planes through one height, so that on the average only the slope differs.
    HeightField plane(GridFrame::centred(128, 128, 10.0));
    for (int y = 0; y < 128; ++y) {
      for (int x = 0; x < 128; ++x) plane(x, y) = 250.0F + slope * static_cast<float>(plane.frame().x(x) / 640.0);
    }
    return height_layers(plane, {100, 60, 250, 60}, true, 1.0, {}).middle;
  };
  const Mask level = mean_middle(1.0F), inclined = mean_middle(400.0F);
  double on_level = 0, on_inclined = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 60; x < 68; ++x) {  // within 25 m of the border on both planes
      on_level += level(x, y);
      on_inclined += inclined(x, y);
    }
  }
  EXPECT_GT(on_inclined, 1.2 * on_level);
}

TEST(HeightLayers, SameBytesForAnyNumberOfThreads) {
  const HeightField terrain = hills(400, 300);
  const Layers one = height_layers(terrain, kMetres, true, 0.7, {.threads = 1});
  const Layers three = height_layers(terrain, kMetres, true, 0.7, {.threads = 3});
  EXPECT_EQ(one.low, three.low);
  EXPECT_EQ(one.middle, three.middle);
  EXPECT_EQ(one.high, three.high);
}

}  // namespace
}  // namespace seamount::geom
