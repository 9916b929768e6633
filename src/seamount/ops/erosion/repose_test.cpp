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
    drainage.route(z, border_outlets(z, 60), 10, {}, room, {});
    const HeightField judge = lowered_plainly(z, drainage, 0.7);
    limit_slopes(z, drainage, {}, 0.7, {});
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
  drainage.route(z, outlets, -1, {}, room, {});
  limit_slopes(z, drainage, {}, 0.6, {});
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
  drainage.route(z, border_outlets(z, 60), -100, {}, room, {});
  limit_slopes(z, drainage, site, 1.0, {});
  EXPECT_NEAR(z(14, 5), 50, 0.01);
  EXPECT_NEAR(z(14, 15), 100, 0.01);
  EXPECT_EQ(z(14, 0), 500);
}

}  // namespace
}  // namespace seamount::erosion
