#include "seamount/ops/erosion/drainage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <queue>

namespace seamount::erosion {
namespace {

HeightField rough(int width, int height, uint64_t seed) {
  HeightField z(GridFrame::centred(width, height, 10));
  Rng rng(Seed{seed});
  for (float& value : z.cells()) value = static_cast<float>(rng.uniform(0, 100));
  return z;
}

/// Water level of each cell by flooding from the roots in order of height: the plain priority flood.
std::vector<float> flooded(const HeightField& z, const Grid<uint8_t>& outlets, float sea_m) {
  using Item = std::pair<float, int32_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  std::vector<float> water(z.size(), INFINITY);
  for (size_t i = 0; i < z.size(); ++i) {
    if (outlets.data()[i] == 0 && z.data()[i] >= sea_m) continue;
    water[i] = std::max(sea_m, z.data()[i]);
    queue.push({water[i], static_cast<int32_t>(i)});
  }
  while (!queue.empty()) {
    const auto [level, cell] = queue.top();
    queue.pop();
    const int x = cell % z.width(), y = cell / z.width();
    for (int d = 0; d < 8; ++d) {
      if (!z.contains(x + geom::kFlowDx[d], y + geom::kFlowDy[d])) continue;
      const int32_t other = (y + geom::kFlowDy[d]) * z.width() + x + geom::kFlowDx[d];
      if (water[other] != INFINITY) continue;
      water[other] = std::max(level, z.data()[other]);
      queue.push({water[other], other});
    }
  }
  return water;
}

TEST(Drainage, LeadsEveryCellOutOverTheLowestPasses) {
  for (const auto& [width, height] : {std::pair{40, 30}, {1, 20}, {20, 1}, {2, 15}, {1, 1}, {3, 3}}) {
    for (uint64_t seed = 0; seed < 20; ++seed) {
      const HeightField z = rough(width, height, seed);
      const float sea_m = seed % 2 == 0 ? 5.0F : -1.0F;
      const Grid<uint8_t> outlets = border_outlets(z, 100);
      Drainage drainage;
      ScalarField room(z.frame());
      drainage.route(z, outlets, {sea_m}, Seed{seed}, room, {});
      const std::vector<float> judge = flooded(z, outlets, sea_m);
      std::vector<float> water(z.size(), -1.0F);
      ASSERT_EQ(drainage.order().size(), z.size());
      for (const int32_t cell : drainage.order()) {
        ASSERT_EQ(water[cell], -1.0F) << "visited twice";
        if (drainage.is_root(cell)) {
          water[cell] = std::max(sea_m, z.data()[cell]);
        } else {
          ASSERT_NE(water[drainage.receiver(cell)], -1.0F) << "before its receiver";
          water[cell] = std::max(z.data()[cell], water[drainage.receiver(cell)]);
        }
        ASSERT_EQ(water[cell], judge[cell]);
      }
    }
  }
}

TEST(Drainage, PartsAreWholeCatchmentsBesideATrunk) {
  HeightField z = rough(300, 260, 4);
  for (int y = 0; y < 260; ++y) {
    for (int x = 0; x < 300; ++x) z(x, y) = 0.2F * z(x, y) + static_cast<float>(y) + 0.5F * std::abs(x - 150.0F);
  }
  Grid<uint8_t> outlets(z.frame(), 0);
  outlets(150, 0) = 1;
  ScalarField room(z.frame());
  Drainage drainage;
  drainage.route(z, outlets, {-1}, Seed{1}, room, {});
  size_t cells = drainage.trunk().size();
  for (const int32_t cell : drainage.trunk()) EXPECT_EQ(drainage.part_of(cell), Drainage::kTrunk);
  for (size_t part = 0; part < drainage.parts(); ++part) {
    cells += drainage.part(part).size();
    for (const int32_t cell : drainage.part(part)) {
      ASSERT_EQ(drainage.part_of(cell), part);
      if (drainage.is_root(cell)) continue;
      const uint8_t below = drainage.part_of(drainage.receiver(cell));
      ASSERT_TRUE(below == part || below == Drainage::kTrunk);
    }
  }
  EXPECT_EQ(cells, z.size());
  EXPECT_GT(drainage.parts(), 3);
  EXPECT_LT(drainage.trunk().size(), z.size() / 50);
}

TEST(Drainage, ABorderHasItsOutletsWhereValleysLeave) {
  HeightField z(GridFrame::centred(64, 64, 10));
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) z(x, y) = 100.0F + static_cast<float>(std::abs(x - 30)) * 5.0F + 100.0F - y;
  }
  const Grid<uint8_t> outlets = border_outlets(z, 200);
  EXPECT_EQ(outlets(30, 63), 1);
  EXPECT_EQ(outlets(10, 63), 0);
  EXPECT_EQ(outlets(0, 20), 0);
  const HeightField flat(GridFrame::centred(8, 6, 10), 3.0F);
  const Grid<uint8_t> all = border_outlets(flat, 20);
  EXPECT_EQ(std::count(all.cells().begin(), all.cells().end(), 1), 2 * (8 + 6) - 4);
}

TEST(Drainage, FollowsASlopeInAnyDirectionOnAverage) {
  for (double angle = 0; angle < 6.28; angle += 0.37) {
    HeightField z(GridFrame::centred(120, 120, 10));
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 120; ++x) z(x, y) = static_cast<float>(-2 * (x * std::cos(angle) + y * std::sin(angle)));
    }
    Drainage drainage;
    ScalarField room(z.frame());
    drainage.route(z, border_outlets(z, 10), {-1e6F}, Seed{1}, room, {});
    double dx = 0, dy = 0;
    for (int y = 1; y < 119; ++y) {
      for (int x = 1; x < 119; ++x) {
        const uint8_t way = drainage.direction(y * 120 + x);
        ASSERT_LT(way, 8);
        dx += geom::kFlowDx[way], dy += geom::kFlowDy[way];
      }
    }
    EXPECT_NEAR(std::remainder(std::atan2(dy, dx) - angle, 2 * 3.14159265), 0.0, 0.02) << angle;
  }
}

TEST(Drainage, NeverTurnsOffAWayThatIsCertain) {
  // Due east: a draw near 1 must not round up to the next direction.
  HeightField z(GridFrame::centred(1500, 1500, 10));
  for (int y = 0; y < 1500; ++y) {
    for (int x = 0; x < 1500; ++x) z(x, y) = static_cast<float>(1500 - x);
  }
  Drainage drainage;
  ScalarField room(z.frame());
  const Grid<uint8_t> outlets = border_outlets(z, 10);
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    drainage.route(z, outlets, {-1e6F}, Seed{seed}, room, {});
    int64_t astray = 0;
    for (int y = 1; y < 1499; ++y) {
      for (int x = 1; x < 1499; ++x) astray += drainage.direction(y * 1500 + x) == 0 ? 0 : 1;
    }
    EXPECT_EQ(astray, 0) << seed;
  }
}

TEST(Drainage, DrawsTheSameWaysForTheSameSeed) {
  HeightField z(GridFrame::centred(50, 50, 10));
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 50; ++x) z(x, y) = static_cast<float>(2 * x + y);
  }
  const Grid<uint8_t> outlets = border_outlets(z, 100);
  const auto ways = [&](uint64_t seed, int threads) {
    Drainage drainage;
    ScalarField room(z.frame());
    drainage.route(z, outlets, {-1}, Seed{seed}, room, {.threads = threads});
    std::vector<int> all;
    for (int32_t i = 0; i < 2500; ++i) all.push_back(drainage.direction(i));
    return all;
  };
  EXPECT_EQ(ways(1, 1), ways(1, 2));
  EXPECT_NE(ways(1, 1), ways(2, 1));
}

}  // namespace
}  // namespace seamount::erosion
