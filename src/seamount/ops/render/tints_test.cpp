#include "seamount/ops/render/tints.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace seamount::render {
namespace {

TEST(Tints, LandAndSeaMeetWithoutAJump) {
  const TintScale scale(-4200.0, 1530.0);
  const Rgb below = scale.tint(-0.01F), above = scale.tint(0.01F);
  EXPECT_NEAR(lightness(below), lightness(above), 0.01F);
  EXPECT_NEAR(below.b, above.b, 0.02F);
}

TEST(Tints, DeeperIsDarker) {
  const TintScale scale(-5000.0, 100.0);
  float previous = 2.0F;
  for (float depth = 0.0F; depth <= 5000.0F; depth += 10.0F) {
    const float l = lightness(scale.tint(-depth));
    EXPECT_LE(l, previous + 1e-4F) << depth;
    previous = l;
  }
}

TEST(Tints, BarPlacesAreMonotoneAndInvertible) {
  for (const auto& [low, high] : {std::pair{-800.0, 1500.0}, {0.0, 3.0}, {-30.0, -2.0}, {2100.0, 4800.0}}) {
    const TintScale scale(low, high);
    double previous = -1.0;
    for (int i = 0; i <= 100; ++i) {
      const double h = low + (high - low) * i / 100.0, place = scale.bar_place(h);
      EXPECT_GE(place, previous);
      EXPECT_GE(place, 0.0);
      EXPECT_LE(place, 1.0);
      EXPECT_NEAR(scale.bar_height(place), h, 1e-6 * (high - low));
      previous = place;
    }
  }
}

TEST(Tints, TicksKeepTheirDistanceAndHoldTheCoast) {
  for (const auto& [low, high] :
       {std::pair{-800.0, 1500.0}, {-11000.0, 8848.0}, {0.0, 0.4}, {-12.0, 0.0}, {900.0, 910.0}}) {
    const TintScale scale(low, high);
    const std::vector<TintScale::Tick> ticks = scale.ticks(0.05);
    ASSERT_GE(ticks.size(), 2U) << low << " " << high;
    for (size_t i = 1; i < ticks.size(); ++i) {
      EXPECT_GE(ticks[i].place - ticks[i - 1].place, 0.0499);
      EXPECT_NEAR(ticks[i].place, scale.bar_place(ticks[i].height_m), 1e-9);
    }
    EXPECT_TRUE(low >= 0.0 || std::any_of(ticks.begin(), ticks.end(),
                                          [](const TintScale::Tick& tick) { return tick.height_m == 0.0; }));
  }
}

TEST(Tints, APlainHasAScaleToo) {
  const TintScale scale(0.0, 0.0);
  EXPECT_GE(scale.tint(0.0F).g, 0.5F);
  EXPECT_GE(scale.ticks(0.1).size(), 2U);
}

TEST(Tints, RoundNumbers) {
  EXPECT_DOUBLE_EQ(round_down_nice(19.9), 10.0);
  EXPECT_DOUBLE_EQ(round_down_nice(0.5), 0.5);
  EXPECT_DOUBLE_EQ(round_down_nice(4999.0), 2000.0);
  EXPECT_EQ(height_text(-1500.0), "\u22121\u2009500");
  EXPECT_EQ(height_text(200.0), "200");
  EXPECT_EQ(height_text(3 * 0.2), "0.6");
}

}  // namespace
}  // namespace seamount::render
