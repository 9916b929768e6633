#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/water/flow_invert.h"
#include "seamount/geom/water/inland.h"
#include "seamount/ops/sketch/extract.h"
#include "seamount/ops/sketch/levelset.h"
#include "seamount/ops/sketch/stochastic_flow.h"

namespace seamount::sketch {
namespace {

HeightField hills(int width, int height, uint64_t seed, float base = 400.0F) {
  HeightField terrain =
      geom::fbm_grid(GridFrame::centred(width, height, 30), Seed{seed}, {.wavelength_m = 2500, .octaves = 6}, {});
  for (float& z : terrain.cells()) z = base + 500.0F * z;
  return terrain;
}

uint64_t sum(const Grid<uint32_t>& grid) {
  uint64_t total = 0;
  for (const uint32_t value : grid.cells()) total += value;
  return total;
}

TEST(StochasticFlow, ChoosesInProportionToTheFall) {
  // From the middle of a 3 x 3 field down by 6 to the east, 3 to the south, 1 to the north-west.
  HeightField surface(GridFrame::centred(3, 3, 1), 20.0F);
  surface(1, 1) = 10.0F;
  surface(2, 1) = 4.0F;
  surface(1, 2) = 7.0F;
  surface(0, 0) = 9.0F;
  Grid<uint8_t> starts(surface.frame(), 0);
  starts(1, 1) = 1;
  constexpr int kDrops = 40000;
  const Water water = stochastic_flow(surface, starts, geom::kNoSea, 1e9F, {.drops = kDrops}, Seed{4}, {});
  double chi = 0;
  for (const auto& [x, y, share] : {std::tuple{2, 1, 0.6}, {1, 2, 0.3}, {0, 0, 0.1}}) {
    const double expected = share * kDrops, found = water.passed(x, y);
    chi += (found - expected) * (found - expected) / expected;
  }
  EXPECT_LT(chi, 9.2);  // 99 % of chi-squared with two degrees of freedom
  EXPECT_EQ(sum(water.passed), 2U * kDrops);
}

TEST(StochasticFlow, MinimaLetAShareOfTheDropsThrough) {
  // A pit of 10 m behind a pass, in a channel to the east.
  HeightField surface(GridFrame::centred(7, 3, 1), 100.0F);
  const float bed[7] = {100, 30, 10, 20, 5, 4, 3};
  for (int x = 0; x < 7; ++x) surface(x, 1) = bed[x];
  Grid<uint8_t> starts(surface.frame(), 0);
  starts(1, 1) = 1;
  constexpr int kDrops = 10000;
  const auto left = [&](double leave, float shallow) {
    const Water water = stochastic_flow(surface, starts, geom::kNoSea, 1e9F,
                                        {.leave = leave, .shallow_m = shallow, .drops = kDrops}, Seed{1}, {});
    EXPECT_EQ(water.ended(2, 1) + water.passed(6, 1), static_cast<uint32_t>(kDrops));
    return static_cast<double>(water.passed(6, 1)) / kDrops;
  };
  EXPECT_NEAR(left(0.2, 2.0F), 0.2, 0.02);
  EXPECT_EQ(left(0.0, 2.0F), 0.0);
  EXPECT_EQ(left(0.0, 10.0F), 1.0);
}

TEST(StochasticFlow, LosesNoDrop) {
  const HeightField surface = hills(60, 50, 3, 50.0F);
  const Grid<uint8_t> starts(surface.frame(), 1);
  const Water water = stochastic_flow(surface, starts, 0.0F, 1e9F, {}, Seed{1}, {});
  uint64_t ended = sum(water.ended);
  const geom::FlowDirections codes = geom::flow_directions(surface, 0.0F, {});
  for (size_t i = 0; i < surface.size(); ++i) ended += codes.data()[i] == geom::kOutlet ? water.passed.data()[i] : 0;
  EXPECT_EQ(ended, surface.size());
}

TEST(Extract, LinesAreOneCellWideSparseAndLong) {
  for (const uint64_t seed : {1, 2, 3}) {
    const HeightField terrain = hills(256, 200, seed);
    const Sketch sketch = extract(terrain, {}, Seed{seed}, {});
    for (const Mask* mask : {&sketch.river, &sketch.ridge}) {
      int set = 0;
      for (int y = 0; y + 1 < terrain.height(); ++y) {
        for (int x = 0; x + 1 < terrain.width(); ++x) {
          set += (*mask)(x, y) > 0 ? 1 : 0;
          EXPECT_LT((*mask)(x, y) + (*mask)(x + 1, y) + (*mask)(x, y + 1) + (*mask)(x + 1, y + 1), 4.0F);
        }
      }
      const double share = set / static_cast<double>(terrain.size());
      EXPECT_GT(share, 0.003);
      EXPECT_LT(share, 0.06);
    }
  }
}

TEST(Extract, RiversRunLowAndRidgesHigh) {
  const HeightField terrain = hills(256, 256, 5);
  const Sketch sketch = extract(terrain, {}, Seed{5}, {});
  double river = 0, ridge = 0, rivers = 0, ridges = 0, mean = 0;
  for (size_t i = 0; i < terrain.size(); ++i) {
    const auto z = static_cast<double>(terrain.data()[i]);
    mean += z / static_cast<double>(terrain.size());
    if (sketch.river.data()[i] > 0) river += z, ++rivers;
    if (sketch.ridge.data()[i] > 0) ridge += z, ++ridges;
  }
  EXPECT_LT(river / rivers, mean - 30);
  EXPECT_GT(ridge / ridges, mean + 30);
  for (const ValuedPoint& cue : sketch.lines.points) EXPECT_GT(std::abs(cue.value - mean), 5) << cue.value;
}

TEST(Extract, RidgesAreTheRiversOfTheInvertedTerrain) {
  HeightField inverted = hills(200, 200, 8, 0.0F), terrain = inverted;
  for (float& z : terrain.cells()) z = 2000.0F + z;
  for (float& z : inverted.cells()) z = 2000.0F - z;
  const Sketch upright = extract(terrain, {.cues = false}, Seed{1}, {});
  const Sketch turned = extract(inverted, {.cues = false}, Seed{1}, {});
  // Away from the edge, where water leaves one of them and not the other: most ridge cells have a river cell of the
  // other within three.
  int near = 0, all = 0;
  for (int y = 30; y < 170; ++y) {
    for (int x = 30; x < 170; ++x) {
      if (upright.ridge(x, y) == 0) continue;
      ++all;
      bool found = false;
      for (int dy = -3; dy <= 3; ++dy)
        for (int dx = -3; dx <= 3; ++dx) found = found || turned.river(x + dx, y + dy) > 0;
      near += found ? 1 : 0;
    }
  }
  EXPECT_GT(near, 0.6 * all);
}

TEST(Extract, KeepsToTheLand) {
  HeightField terrain = hills(300, 260, 6, 20.0F);
  for (float& z : terrain.cells()) z = std::max(z, 0.0F);  // a sea of unknown depth, as elevation models have it
  const Sketch sketch = extract(terrain, {}, Seed{1}, {});
  const HeightField ground = geom::raise_inland(terrain, 0.0F, {}, {});
  int lines = 0;
  for (size_t i = 0; i < terrain.size(); ++i) {
    if (sketch.river.data()[i] + sketch.ridge.data()[i] == 0.0F) continue;
    ++lines;
    ASSERT_TRUE(ground.data()[i] > 0.0F) << i;
  }
  EXPECT_GT(lines, 300);
}

TEST(Extract, DrawsTheSeaFloorWhereThereIsNoSea) {
  HeightField terrain = hills(128, 128, 2), drowned = terrain;
  for (float& z : drowned.cells()) z -= 5000.0F;
  const Sketch land = extract(terrain, {.sea = false}, Seed{5}, {}),
               floor = extract(drowned, {.sea = false}, Seed{5}, {});
  double differing = 0, all = 0;
  for (size_t i = 0; i < terrain.size(); ++i) {
    all += static_cast<double>(land.river.data()[i]);
    differing += land.river.data()[i] != floor.river.data()[i] ? 1 : 0;
  }
  EXPECT_GT(all, 200);
  EXPECT_LT(differing, 0.1 * all);  // heights of 5000 m are rounded otherwise
  EXPECT_TRUE(extract(drowned, {}, Seed{5}, {}).lines.lines.empty());
}

TEST(Extract, LeavesOutWhatIsNotWanted) {
  const HeightField terrain = hills(128, 128, 2);
  const Sketch rivers = extract(terrain, {.ridges = false, .cues = false}, Seed{5}, {});
  EXPECT_TRUE(rivers.lines.points.empty());
  for (const ValuedLine& line : rivers.lines.lines) EXPECT_EQ(line.value, 0.0);
  for (size_t i = 0; i < terrain.size(); ++i) {
    EXPECT_EQ(rivers.ridge.data()[i], 0.0F);
    EXPECT_EQ(rivers.image.rgb[3 * i], 0);
    EXPECT_EQ(rivers.image.rgb[3 * i + 1], 0);
    EXPECT_EQ(rivers.image.rgb[3 * i + 2], rivers.river.data()[i] > 0 ? 255 : 0);
  }
}

TEST(Levelset, HoldsTheShareAboveThePercentile) {
  const HeightField terrain = hills(150, 90, 4);
  for (const double percentile : {0.0, 25.0, 60.0, 90.0}) {
    const Levelset made = levelset(terrain, {.percentile = percentile}, {});
    double inside = 0;
    for (const float cell : made.mask.cells()) inside += static_cast<double>(cell);
    EXPECT_NEAR(inside / static_cast<double>(terrain.size()), 1.0 - percentile / 100, 1e-3);
  }
  EXPECT_EQ(levelset(HeightField(GridFrame::centred(5, 4, 1), 7.0F), {}, {}).level_m, 7.0);
}

TEST(Levelset, IsOfTheLand) {
  for (const uint64_t seed : {4, 5, 6}) {
    HeightField island = hills(200, 160, seed, -60.0F), flat_sea = island;
    double land = 0;
    for (float& z : flat_sea.cells()) z = std::max(z, 0.0F), land += z > 0 ? 1 : 0;
    ASSERT_LT(land, 0.6 * 200 * 160);
    for (const HeightField& terrain : {island, flat_sea}) {  // the depth of the sea does not count
      const HeightField ground = geom::raise_inland(terrain, 0.0F, {}, {});
      double dry = 0, inside = 0;
      const Levelset made = levelset(terrain, {.blur_m = 200}, {});
      for (size_t i = 0; i < terrain.size(); ++i) {
        dry += ground.data()[i] > 0 ? 1 : 0;
        inside += static_cast<double>(made.mask.data()[i]);
        ASSERT_TRUE(made.mask.data()[i] == 0.0F || ground.data()[i] > 0.0F) << i;
      }
      EXPECT_NEAR(inside / dry, 0.4, 1e-3);
      EXPECT_GT(made.level_m, 0.0);
    }
    const Levelset floor = levelset(island, {.blur_m = 200, .sea = false}, {});
    double inside = 0;
    for (const float cell : floor.mask.cells()) inside += static_cast<double>(cell);
    EXPECT_NEAR(inside / static_cast<double>(island.size()), 0.4, 1e-3);
    for (float& z : island.cells()) z -= 3000.0F;
    const Levelset drowned = levelset(island, {}, {});
    EXPECT_TRUE(drowned.areas.areas.empty());
    EXPECT_EQ(std::count(drowned.mask.cells().begin(), drowned.mask.cells().end(), 1.0F), 0);
  }
}

TEST(SketchOps, TakeOddShapes) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {9, 1}, {3, 2}, {40, 3}}) {
    const HeightField terrain = hills(width, height, 1);
    EXPECT_EQ(extract(terrain, {}, Seed{1}, {}).river.size(), terrain.size());
    EXPECT_EQ(levelset(terrain, {}, {}).mask.size(), terrain.size());
  }
}

}  // namespace
}  // namespace seamount::sketch
