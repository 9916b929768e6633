#include "seamount/ops/hydrology/breach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/geom/water/flow.h"
#include "seamount/ops/hydrology/lowest_ground.h"
#include "seamount/ops/hydrology/monotone_queue.h"

namespace seamount::hydrology {
namespace {

TEST(Breach, TakesTheCheapestWay) {
  // A pit behind a wall that is thin in the east (cut 5) and has a gap in the south two cells away (cut 2 twice).
  HeightField terrain(GridFrame::centred(9, 9, 1), 20.0F);
  for (int y = 3; y < 6; ++y)
    for (int x = 3; x < 6; ++x) terrain(x, y) = 5.0F;
  terrain(4, 4) = 3.0F;
  for (int x = 6; x < 9; ++x) terrain(x, 4) = x == 6 ? 9.0F : 1.0F;
  for (int y = 6; y < 9; ++y) terrain(4, y) = y < 8 ? 5.0F : 1.0F;
  breach_depressions(terrain, geom::kNoSea, 100, 100.0F, {});
  EXPECT_EQ(terrain(6, 4), 9.0F);
  EXPECT_EQ(terrain(4, 6), 3.0F);
  EXPECT_EQ(terrain(4, 7), 3.0F);
}

/// The textbook: a heap of (cost, steps, cell, order of arrival), every neighbour pushed whether it helps or not.
HeightField breached_plainly(const HeightField& terrain, float sea, int max_steps, float max_cut) {
  HeightField z = terrain;
  const auto steps = geom::flow_steps(z.width());
  const geom::FlowDirections directions = geom::flow_directions(z, sea, {});
  std::vector<int32_t> pits;
  for (int32_t i = 0; i < static_cast<int32_t>(z.size()); ++i)
    if (directions.data()[i] == geom::kPit) pits.push_back(i);
  std::sort(pits.begin(), pits.end(),
            [&](int32_t a, int32_t b) { return std::pair(terrain.data()[a], a) < std::pair(terrain.data()[b], b); });
  for (const int32_t pit : pits) {
    const float floor = z.data()[pit];
    using Front = std::tuple<float, int32_t, int32_t, int64_t, int32_t>;  // cost, steps, cell, order, from
    std::priority_queue<Front, std::vector<Front>, std::greater<>> open;
    std::vector<int32_t> from(z.size(), -1);
    int64_t order = 0;
    open.push({0.0F, 0, pit, order, pit});
    while (!open.empty()) {
      const auto [cost, count, cell, when, before] = open.top();
      open.pop();
      if (from[static_cast<size_t>(cell)] >= 0) continue;
      from[static_cast<size_t>(cell)] = before;
      const int x = cell % z.width(), y = cell / z.width();
      const bool border = x == 0 || y == 0 || x == z.width() - 1 || y == z.height() - 1;
      if (cell != pit && (border || z.data()[cell] < floor || z.data()[cell] <= sea)) {
        for (int32_t at = cell; at != pit; at = from[static_cast<size_t>(at)])
          z.data()[at] = std::min(z.data()[at], floor);
        break;
      }
      if (count >= max_steps) continue;
      for (size_t k = 0; k < 8; ++k) {
        const auto other = static_cast<int32_t>(cell + steps[k]);
        const float depth = std::max(0.0F, z.data()[other] - floor);
        if (depth <= max_cut) open.push({cost + depth * geom::kFlowLength[k], count + 1, other, ++order, cell});
      }
    }
  }
  return z;
}

TEST(Breach, CutsAsTheTextbookDoes) {
  int64_t cut_cells = 0, left = 0;
  for (uint64_t seed = 0; seed < 400; ++seed) {
    Rng rng(Seed{seed}.derive("terrain"));
    HeightField terrain(GridFrame::centred(rng.integer(1, 40), rng.integer(1, 40), 10));
    const int levels = rng.integer(2, 12);
    const bool steps = rng.chance(0.7);  // whole metres: flats, and many ways of one cost
    for (float& z : terrain.cells())
      z = steps ? static_cast<float>(rng.integer(-1, levels)) : static_cast<float>(rng.uniform(-1, levels));
    const float sea = rng.chance(0.5) ? 0.0F : geom::kNoSea;
    const int max_steps = rng.integer(1, 30);
    const auto max_cut = static_cast<float>(rng.chance(0.5) ? 100 : rng.integer(1, 6));
    HeightField breached = terrain;
    breach_depressions(breached, sea, max_steps, max_cut, {});
    ASSERT_EQ(breached, breached_plainly(terrain, sea, max_steps, max_cut)) << seed;
    for (size_t i = 0; i < terrain.size(); ++i) cut_cells += breached.data()[i] < terrain.data()[i] ? 1 : 0;
    left += geom::count_pits(geom::flow_directions(breached, sea, {}));
  }
  EXPECT_GT(cut_cells, 1000);
  EXPECT_GT(left, 100);
}

TEST(Breach, LeavesWhatNoLowerGroundIsNear) {
  // A bowl 6 cells from the border in every direction.
  HeightField terrain(GridFrame::centred(13, 13, 10), 5.0F);
  terrain(6, 6) = 1.0F;
  HeightField cut = terrain;
  breach_depressions(cut, geom::kNoSea, 5, 100.0F, {});
  EXPECT_EQ(cut, terrain);
  breach_depressions(cut, geom::kNoSea, 6, 100.0F, {});
  EXPECT_NE(cut, terrain);
}

TEST(MonotoneQueue, GivesKeysInOrderWithTheirCells) {
  for (uint64_t seed = 0; seed < 50; ++seed) {
    Rng rng(Seed{seed});
    MonotoneQueue queue;
    std::priority_queue<std::pair<uint64_t, int32_t>, std::vector<std::pair<uint64_t, int32_t>>, std::greater<>> plain;
    const auto push = [&](uint64_t from) {
      const uint64_t key = from + static_cast<uint64_t>(rng.integer(0, 5)) * (rng.chance(0.1) ? uint64_t{1} << 40 : 1);
      const int32_t cell = rng.integer(0, 99);
      queue.push(key, cell);
      plain.emplace(key, cell);
    };
    push(0);
    std::vector<int32_t> cells;
    for (int step = 0; step < 300 && !queue.empty(); ++step) {
      queue.take(cells);
      for (const int32_t cell : cells) {
        ASSERT_EQ(plain.top(), std::pair(queue.least(), cell));
        plain.pop();
      }
      for (int k = rng.integer(0, 3); k > 0; --k) push(queue.least());
    }
    ASSERT_EQ(queue.empty(), plain.empty());
  }
}

TEST(LowestGround, SeesEveryCellOfItsBox) {
  HeightField terrain(GridFrame::centred(70, 50, 10), 5.0F);
  LowestGround lowest(terrain);
  EXPECT_FALSE(lowest.has_below(5.0F, 0, 0, 69, 49));
  EXPECT_TRUE(lowest.has_below(5.1F, 3, 3, 3, 3));
  Rng rng(Seed{3});
  for (int trial = 0; trial < 200; ++trial) {
    const int x = rng.integer(0, 69), y = rng.integer(0, 49);
    const int x0 = rng.integer(0, 69), x1 = rng.integer(x0, 69), y0 = rng.integer(0, 49), y1 = rng.integer(y0, 49);
    const float before = terrain(x, y);
    terrain(x, y) = 1.0F;
    LowestGround fresh(terrain);
    EXPECT_EQ(fresh.has_below(2.0F, x0, y0, x1, y1), x >= x0 && x <= x1 && y >= y0 && y <= y1);
    terrain(x, y) = before;
  }
}

}  // namespace
}  // namespace seamount::hydrology
