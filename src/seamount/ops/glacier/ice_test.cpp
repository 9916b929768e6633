#include "seamount/ops/glacier/ice.h"

#include <gtest/gtest.h>

#include <cmath>

namespace seamount::glacier {
namespace {

TEST(Ice, AnIceCapHasVialovsProfile) {
  // A disc of even snow; beyond its edge the ground falls away and everything melts. Without sliding the steady profile
  // is H^(8/3) = 2 (a / 2 G_d)^(1/3) (L^(4/3) - r^(4/3)) (Vialov 1958, radial).
  constexpr double kRadius = 20000, kSnow = 0.5;
  for (const int cells : {51, 101}) {
    HeightField bed(GridFrame::centred(cells, cells, 50000.0 / cells), 0.0F);
    for (int y = 0; y < cells; ++y) {
      for (int x = 0; x < cells; ++x) {
        if (std::hypot(bed.frame().x(x), bed.frame().y(y)) > kRadius) bed(x, y) = -3000;
      }
    }
    HeightField surface = bed;
    Ice ice(bed, surface, {.ela_m = -1, .gradient_1_yr = 1, .most_m_yr = kSnow}, 0.0);
    for (int i = 0; i < 60; ++i) ice.step(500, 20, {});
    const double softness = 1.9e-24 * 3.156e7 * std::pow(910 * 9.81, 3);
    double worst = 0;
    for (int x = cells / 2; x < cells; ++x) {
      const double r = std::abs(bed.frame().x(x));
      if (r > 0.85 * kRadius) break;
      const double expected = std::pow(
          2 * std::cbrt(kSnow / (2 * softness)) * (std::pow(kRadius, 4.0 / 3) - std::pow(r, 4.0 / 3)), 3.0 / 8);
      worst = std::max(worst, std::abs(surface(x, cells / 2) - expected) / expected);
    }
    EXPECT_LT(worst, cells > 60 ? 0.05 : 0.08) << cells;
  }
}

/// A mountain with eight valleys.
HeightField massif(int width, int height, double cell) {
  HeightField bed(GridFrame::centred(width, height, cell));
  const double reach = 0.5 * cell * std::min(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double east = bed.frame().x(x), north = bed.frame().y(y), r = std::hypot(east, north) / reach;
      bed(x, y) =
          static_cast<float>(1000 + 2500 * std::exp(-4 * r * r) + 300 * r * std::cos(8 * std::atan2(north, east)));
    }
  }
  return bed;
}

TEST(Ice, SnowAndMeltBalanceInTheEnd) {
  for (const double ela : {2000.0, 2500.0}) {
    const HeightField bed = massif(100, 100, 200);
    HeightField surface = bed;
    const Climate climate{.ela_m = ela};
    Ice ice(bed, surface, climate);
    for (int i = 0; i < 50; ++i) ice.step(100, 12, {});
    const Budget year = ice.budget();
    EXPECT_GT(year.gained, 1e6);
    EXPECT_NEAR(year.lost, year.gained, 0.02 * year.gained) << ela;
  }
}

TEST(Ice, NoneBelowTheLineIfNothingReachesOverIt) {
  const HeightField bed = massif(40, 60, 100);
  HeightField surface = bed;
  Ice ice(bed, surface, {.ela_m = 4000});
  for (int i = 0; i < 10; ++i) ice.step(10, 5, {});
  EXPECT_TRUE(surface == bed);
}

TEST(Ice, AnyNumberOfThreadsMakesTheSameIce) {
  const HeightField bed = massif(300, 300, 50);
  HeightField one = bed, more = bed;
  Ice first(bed, one, {.ela_m = 1900}), second(bed, more, {.ela_m = 1900});
  for (int i = 0; i < 5; ++i) first.step(10, 5, {.threads = 1}), second.step(10, 5, {.threads = 5});
  EXPECT_TRUE(one == more);
}

}  // namespace
}  // namespace seamount::glacier
