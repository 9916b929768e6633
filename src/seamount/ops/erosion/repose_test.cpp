#include "seamount/ops/erosion/repose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seamount::erosion {
namespace {

/// The height that the four neighbours of a cell and the slope allow it: the solution of |gradient| = steepest by
/// upwind differences, found by bisection.
double allowed(const HeightField& z, int x, int y, double steepest) {
  const auto at = [&](int i, int j) { return z.contains(i, j) ? static_cast<double>(z(i, j)) : 1e30; };
  const double a = std::min(at(x - 1, y), at(x + 1, y)), b = std::min(at(x, y - 1), at(x, y + 1));
  double low = std::min(a, b), high = low + steepest * z.cell_m();
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high), up = std::max(0.0, middle - a), left = std::max(0.0, middle - b);
    (std::hypot(up, left) < steepest * z.cell_m() ? low : high) = middle;
  }
  return low;
}

/// Lowers cells until none is too steep.
HeightField lowered_plainly(HeightField z, const Drainage& drainage, double steepest) {
  for (bool moved = true; moved;) {
    moved = false;
    for (int y = 0; y < z.height(); ++y) {
      for (int x = 0; x < z.width(); ++x) {
        if (drainage.is_root(y * z.width() + x)) continue;
        const auto limit = static_cast<float>(allowed(z, x, y, steepest));
        if (z(x, y) <= limit + 1e-3F) continue;
        z(x, y) = limit;
        moved = true;
      }
    }
  }
  return z;
}

TEST(Repose, IsTheDistanceToTheGroundAround) {
  for (const auto& [width, height] : {std::pair{40, 31}, {1, 12}, {12, 1}, {2, 2}}) {
    HeightField z(GridFrame::centred(width, height, 10));
    Rng rng(Seed{5});
    for (float& value : z.cells()) value = static_cast<float>(rng.uniform(0, 400));
    Drainage drainage;
    ScalarField room(z.frame());
    drainage.route(z, border_outlets(z, 60), {10}, {}, room, {});
    const HeightField judge = lowered_plainly(z, drainage, 0.7);
    limit_slopes(z, drainage, {}, ScalarField(z.frame(), 7.0F), {});
    for (size_t i = 0; i < z.size(); ++i) EXPECT_NEAR(z.data()[i], judge.data()[i], 0.1) << i;
  }
}

TEST(Repose, AroundAPointStandsACone) {
  const int size = 81;
  HeightField z(GridFrame::centred(size, size, 10), 1e5F);
  z(40, 40) = 0;
  Grid<uint8_t> outlets(z.frame(), 0);
  outlets(40, 40) = 1;
  Drainage drainage;
  ScalarField room(z.frame());
  drainage.route(z, outlets, {-1}, {}, room, {});
  limit_slopes(z, drainage, {}, ScalarField(z.frame(), 6.0F), {});
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double distance = 10 * std::hypot(x - 40, y - 40);
      if (distance < 150) continue;
      EXPECT_NEAR(z(x, y) / (0.6 * distance), 1.0, 0.06) << x << " " << y;  // of eight sides: up to 8 % more
    }
  }
}

TEST(Repose, HardRockStandsSteeperAndMasksHold) {
  const GridFrame frame = GridFrame::centred(30, 20, 10);
  HeightField z(frame, 0.0F);
  for (int y = 0; y < 20; ++y) {
    for (int x = 10; x < 30; ++x) z(x, y) = 500;
  }
  Maps site{.hardness = ScalarField(frame, 1.0F), .mask = Mask(frame, 1.0F), .uplift = {}, .rain = {}};
  for (int x = 0; x < 30; ++x) {
    for (int y = 10; y < 20; ++y) site.hardness(x, y) = 4;
    site.mask(x, 0) = 0;
  }
  Drainage drainage;
  ScalarField room(z.frame());
  drainage.route(z, border_outlets(z, 60), {-100}, {}, room, {});
  ScalarField rise(frame);
  find_steepest_rise(ScalarField(frame, 0.0F), site, {.steepest = 1.0}, rise, {});
  limit_slopes(z, drainage, site, rise, {});
  EXPECT_NEAR(z(14, 5), 50, 0.01);
  EXPECT_NEAR(z(14, 15), 100, 0.01);
  EXPECT_EQ(z(14, 0), 500);
}

TEST(Repose, RockIsUnevenAboutItsAngleAndHollowsAreGentler) {
  const GridFrame frame = GridFrame::centred(200, 150, 20);
  ScalarField dry(frame, 0.0F), wet(frame, 7.0F), rise(frame), hollow(frame);
  const Strength strength{.steepest = 0.8, .variation = 0.6, .hollow_m3_yr = 1.0, .seed = Seed{3}};
  find_steepest_rise(dry, {}, strength, rise, {});
  find_steepest_rise(wet, {}, strength, hollow, {});
  double sum = 0, square = 0;
  for (size_t i = 0; i < rise.size(); ++i) {
    const double own = std::log(rise.data()[i] / 16.0);
    sum += own, square += own * own;
    EXPECT_NEAR(hollow.data()[i], rise.data()[i] / 1.09, 1e-4 * rise.data()[i]);  // three doublings
  }
  const double mean = sum / static_cast<double>(rise.size());
  EXPECT_NEAR(mean, 0.0, 0.05);
  EXPECT_NEAR(std::sqrt(square / static_cast<double>(rise.size()) - mean * mean), 0.3, 0.15);
  // The same rock on coarser cells.
  const GridFrame coarse = GridFrame::centred(100, 75, 40);
  ScalarField there(coarse);
  find_steepest_rise(ScalarField(coarse, 0.0F), {}, strength, there, {});
  double apart = 0;
  for (int y = 0; y < 75; ++y) {
    for (int x = 0; x < 100; ++x) {
      const double means =
          0.25 * (rise(2 * x, 2 * y) + rise(2 * x + 1, 2 * y) + rise(2 * x, 2 * y + 1) + rise(2 * x + 1, 2 * y + 1));
      apart += std::abs(there(x, y) / 2 - means) / means;
    }
  }
  EXPECT_LT(apart / 7500, 0.15);
}

}  // namespace
}  // namespace seamount::erosion
