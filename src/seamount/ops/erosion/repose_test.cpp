#include "seamount/ops/erosion/repose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seamount::erosion {
namespace {

/// Lowers cells until none is too steep, one neighbour at a time.
HeightField lowered_plainly(HeightField z, const Drainage& drainage, double steepest) {
  for (bool moved = true; moved;) {
    moved = false;
    for (int y = 0; y < z.height(); ++y) {
      for (int x = 0; x < z.width(); ++x) {
        if (drainage.is_root(y * z.width() + x)) continue;
        for (int d = 0; d < 8; ++d) {
          if (!z.contains(x + geom::kFlowDx[d], y + geom::kFlowDy[d])) continue;
          const double reach = steepest * z.cell_m() * (d % 2 == 0 ? 1.0 : std::numbers::sqrt2);
          const auto limit = static_cast<float>(z(x + geom::kFlowDx[d], y + geom::kFlowDy[d]) + reach);
          if (z(x, y) <= limit + 1e-3F) continue;
          z(x, y) = limit;
          moved = true;
        }
      }
    }
  }
  return z;
}

TEST(Repose, IsTheDistanceTransformOfTheGround) {
  for (const auto& [width, height] : {std::pair{40, 31}, {1, 12}, {12, 1}, {2, 2}}) {
    HeightField z(GridFrame::centred(width, height, 10));
    Rng rng(Seed{5});
    for (float& value : z.cells()) value = static_cast<float>(rng.uniform(0, 400));
    Drainage drainage;
    ScalarField room(z.frame());
    drainage.route(z, border_outlets(z, 60), 10, 0, Seed{}, room, {});
    const HeightField judge = lowered_plainly(z, drainage, 0.7);
    limit_slopes(z, drainage, {}, 0.7, {});
    for (size_t i = 0; i < z.size(); ++i) EXPECT_NEAR(z.data()[i], judge.data()[i], 0.1) << i;
  }
}

TEST(Repose, HardRockStandsSteeperAndMasksHold) {
  const GridFrame frame = GridFrame::centred(30, 20, 10);
  HeightField z(frame, 0.0F);
  for (int y = 0; y < 20; ++y) {
    for (int x = 10; x < 30; ++x) z(x, y) = 500;
  }
  Site site{.hardness = ScalarField(frame, 1.0F), .mask = Mask(frame, 1.0F), .uplift = {}};
  for (int x = 0; x < 30; ++x) {
    for (int y = 10; y < 20; ++y) site.hardness(x, y) = 4;
    site.mask(x, 0) = 0;
  }
  Drainage drainage;
  ScalarField room(z.frame());
  drainage.route(z, border_outlets(z, 60), -100, 0, Seed{}, room, {});
  limit_slopes(z, drainage, site, 1.0, {});
  EXPECT_NEAR(z(14, 5), 50, 0.01);
  EXPECT_NEAR(z(14, 15), 100, 0.01);
  EXPECT_EQ(z(14, 0), 500);
}

}  // namespace
}  // namespace seamount::erosion
