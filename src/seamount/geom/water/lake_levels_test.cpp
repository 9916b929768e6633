#include "seamount/geom/water/lake_levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

HeightField rough_terrain(int width, int height, uint64_t seed) {
  HeightField terrain(GridFrame::centred(width, height, 10));
  Rng rng(Seed{seed});
  for (float& z : terrain.cells()) z = static_cast<float>(rng.uniform(-10, 100));
  return terrain;
}

HeightField stepped_terrain(int width, int height, uint64_t seed) {
  HeightField terrain = rough_terrain(width, height, seed);
  for (float& z : terrain.cells()) z = std::round(0.1F * z);
  return terrain;
}

HeightField surface_of(const HeightField& terrain, const LakeLevels& levels) {
  HeightField surface = terrain;
  for (size_t i = 0; i < terrain.size(); ++i)
    if (const int32_t lake = levels.lake.data()[i]; lake >= 0)
      surface.data()[i] = levels.lakes[static_cast<size_t>(lake)].level_m;
  return surface;
}

/// The terrain in which flow ends in closed lakes and in dry pits, and there alone inside.
HeightField open_sinks(const HeightField& terrain, const LakeLevels& levels) {
  HeightField open = terrain;
  for (size_t i = 0; i < terrain.size(); ++i)
    if (const int32_t lake = levels.lake.data()[i]; lake >= 0 && levels.lakes[static_cast<size_t>(lake)].closed)
      open.data()[i] = kNoSea;
  for (const StandingLake& lake : levels.lakes)
    if (lake.closed) open.data()[lake.pit] = kNoSea;
  return open;
}

TEST(LakeLevels, WithoutLossesAreThoseOfFilling) {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    Rng rng(Seed{seed}.derive("size"));
    const int width = rng.integer(1, 30), height = rng.integer(1, 30);
    const float sea = seed % 2 == 0 ? kNoSea : 0.0F;
    for (const HeightField& terrain : {rough_terrain(width, height, seed), stepped_terrain(width, height, seed)}) {
      const LakeLevels levels = lake_levels(terrain, sea, {.loss_mm_yr = 0.0}, {});
      // Where dry ground gives what wet ground loses, a lake takes as much as its own ground gave: it still overflows.
      const LakeLevels none = lake_levels(terrain, sea, {.loss_mm_yr = -100.0}, {});
      EXPECT_EQ(surface_of(terrain, none), fill_depressions(terrain, sea, {})) << seed;
      for (const StandingLake& lake : none.lakes) EXPECT_FALSE(lake.closed);
      for (size_t i = 0; i < levels.lakes.size(); ++i) EXPECT_LE(levels.lakes[i].level_m, levels.lakes[i].pass_m);
    }
  }
}

TEST(LakeLevels, DryUpWhereTheSunTakesAll) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const HeightField terrain = rough_terrain(40, 30, seed);
    const LakeLevels levels = lake_levels(terrain, kNoSea, {.loss_mm_yr = 1e9}, {});
    EXPECT_EQ(static_cast<int64_t>(levels.lakes.size()), count_pits(flow_directions(terrain, kNoSea, {})));
    for (const int32_t lake : levels.lake.cells()) EXPECT_EQ(lake, -1);
    for (const StandingLake& lake : levels.lakes) {
      EXPECT_TRUE(lake.closed);
      EXPECT_EQ(lake.level_m, terrain.data()[lake.pit]);
    }
  }
}

/// A crater of slope 1 between the rim at 900 m and its middle.
TEST(LakeLevels, OfAConeIsWhereRunoffMeetsLoss) {
  HeightField terrain(GridFrame::centred(401, 401, 5));
  for (int y = 0; y < 401; ++y)
    for (int x = 0; x < 401; ++x)
      terrain(x, y) = static_cast<float>(900.0 - std::abs(900.0 - 5.0 * std::hypot(x - 200, y - 200)));
  for (const double loss : {900.0, 300.0, 4900.0}) {
    const LakeLevels levels = lake_levels(terrain, kNoSea, {.runoff_mm_yr = 100.0, .loss_mm_yr = loss}, {});
    ASSERT_EQ(levels.lakes.size(), 1U);
    const StandingLake& lake = levels.lakes[0];
    const double radius = 900.0 * std::sqrt(100.0 / (100.0 + loss));
    EXPECT_TRUE(lake.closed);
    EXPECT_NEAR(lake.level_m, radius, 10.0);
    EXPECT_NEAR(static_cast<double>(lake.cells) * 25.0, M_PI * radius * radius, 0.02 * M_PI * radius * radius);
    EXPECT_NEAR(lake.inflow, static_cast<double>(lake.cells) * 25.0 * loss * 1e-3, 0.02 * lake.inflow);
  }
}

/// Heights along the middle row of high walls: water can only follow the row.
TEST(LakeLevels, OverflowFeedsTheNextAndFullNeighboursJoin) {
  const std::vector<float> profile = {95, 90, 20, 10, 20, 50, 20, 5, 20, 92};
  HeightField terrain(GridFrame::centred(10, 5, 1000), 1000.0F);
  for (int x = 0; x < 10; ++x) terrain(x, 2) = profile[static_cast<size_t>(x)];
  ScalarField runoff(terrain.frame(), 0.0F);
  runoff(3, 1) = 1000.0F;  // on the wall above the left hollow
  const auto solve = [&](double loss) {
    return lake_levels(terrain, kNoSea, {.runoff_map = &runoff, .loss_mm_yr = loss}, {}).lakes;
  };
  // 400 a cell: two cells take 800; the third is at the second's height and would make it 1200.
  std::vector<StandingLake> lakes = solve(400);
  ASSERT_EQ(lakes.size(), 2U);
  EXPECT_EQ(lakes[0].cells, 1);
  EXPECT_EQ(lakes[0].level_m, 20.0F);
  EXPECT_EQ(lakes[1].cells, 0);
  // 300: the left one is full with three cells, 100 go over the sill at 50 and keep no cell wet.
  lakes = solve(300);
  EXPECT_FALSE(lakes[0].closed);
  EXPECT_EQ(lakes[0].level_m, 50.0F);
  EXPECT_NEAR(lakes[0].outflow, 100e3, 1e-3);
  EXPECT_EQ(lakes[1].cells, 0);
  EXPECT_NEAR(lakes[1].inflow, 100e3, 1e-3);
  // 200: 400 go over, which one cell at 5 holds, but not the two beside it.
  lakes = solve(200);
  EXPECT_FALSE(lakes[0].closed);
  EXPECT_TRUE(lakes[1].closed);
  EXPECT_EQ(lakes[1].cells, 1);
  EXPECT_EQ(lakes[1].level_m, 20.0F);
  // 150: both are full with 900 of 1000 and join, which the sill at 50 makes 1050: it stays at the sill.
  lakes = solve(150);
  ASSERT_EQ(lakes.size(), 1U);
  EXPECT_TRUE(lakes[0].closed);
  EXPECT_EQ(lakes[0].cells, 6);
  EXPECT_EQ(lakes[0].level_m, 50.0F);
  EXPECT_EQ(lakes[0].pit, 2 * 10 + 7);
  // 140: the sill is under water.
  lakes = solve(140);
  EXPECT_EQ(lakes[0].cells, 7);
  EXPECT_EQ(lakes[0].level_m, 90.0F);
  // 120: so is the cell at 90, and what is left leaves over the border at 92.
  lakes = solve(120);
  ASSERT_EQ(lakes.size(), 1U);
  EXPECT_FALSE(lakes[0].closed);
  EXPECT_EQ(lakes[0].level_m, 92.0F);
  EXPECT_NEAR(lakes[0].outflow, 1000e3 - 8 * 120e3, 1e-3);
}

/// Down the ground where it is dry, over the water's surface to the sill where a lake overflows, and on from there.
FlowDirections routes(const HeightField& terrain, const HeightField& routed, const LakeLevels& levels, float sea) {
  const FlowDirections ground = flow_directions(terrain, sea, {}), water = flow_directions(routed, sea, {});
  const auto steps = flow_steps(terrain.width());
  FlowDirections out = ground;
  for (int64_t i = 0; i < terrain.frame().cells(); ++i) {
    if (routed.data()[i] > terrain.data()[i]) out.data()[i] = water.data()[i];
    if (routed.data()[i] > terrain.data()[i] || ground.data()[i] >= 8) continue;
    const int64_t to = i + steps[ground.data()[i]];
    if (routed.data()[to] < terrain.data()[i]) continue;
    float best = 0.0F;  // a sill that drains into its own lake
    for (uint8_t k = 0; k < 8; ++k) {
      const float drop = terrain.data()[i] - std::max(sea, terrain.data()[i + steps[k]]);
      const float slope = drop * (k % 2 == 0 ? 1.0F : 0.70710678F);
      if (levels.lake.data()[i + steps[k]] == levels.lake.data()[to] || slope <= best) continue;
      best = slope;
      out.data()[i] = k;
    }
  }
  return out;
}

TEST(LakeLevels, StandWhereEachIsInBalance) {
  int64_t closed_wet = 0, overflowing = 0, joined = 0, fed = 0;
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    Rng rng(Seed{seed}.derive("climate"));
    const int width = rng.integer(1, 40), height = rng.integer(1, 40);
    const bool unique = rng.chance(0.7);
    const HeightField terrain = unique ? rough_terrain(width, height, seed) : stepped_terrain(width, height, seed);
    const float sea = rng.chance(0.5) ? kNoSea : 0.0F;
    ScalarField runoff(terrain.frame(), 100.0F);
    if (rng.chance(0.5))
      for (float& value : runoff.cells()) value = static_cast<float>(rng.uniform(0, 300));
    const double loss = rng.uniform(0, rng.chance(0.5) ? 300 : 3000);
    const LakeLevels levels = lake_levels(terrain, sea, {.runoff_map = &runoff, .loss_mm_yr = loss}, {});
    const HeightField surface = surface_of(terrain, levels), open = open_sinks(terrain, levels);

    // All that is no closed lake stands as filling leaves it, with closed lakes and dry pits as the ends of flow.
    const HeightField filled = fill_depressions(open, sea, {});
    for (size_t i = 0; i < terrain.size(); ++i)
      ASSERT_EQ(filled.data()[i], open.data()[i] > kNoSea ? surface.data()[i] : kNoSea) << seed;
    if (!unique) continue;

    // What runs there: dry ground gives its runoff, overflowing lakes take their loss; closed lakes lie over pits.
    HeightField routed = terrain;
    for (size_t i = 0; i < terrain.size(); ++i)
      if (open.data()[i] > kNoSea) routed.data()[i] = surface.data()[i];
    const FlowDirections directions = routes(terrain, routed, levels, sea);
    Grid<int32_t> end(terrain.frame(), -1);
    std::vector<double> inflow(levels.lakes.size() + 1, 0.0);
    for (size_t k = 0; k < levels.lakes.size(); ++k)
      if (levels.lakes[k].closed) end.data()[levels.lakes[k].pit] = static_cast<int32_t>(k);
    for (size_t i = 0; i < terrain.size(); ++i) {
      if (directions.data()[i] == kOutlet) end.data()[i] = static_cast<int32_t>(levels.lakes.size());
      if (directions.data()[i] != kPit) continue;
      ASSERT_EQ(open.data()[i], kNoSea) << seed;
      if (levels.lake.data()[i] >= 0) end.data()[i] = levels.lake.data()[i];
    }
    label_upstream(directions, end, {});
    for (size_t i = 0; i < terrain.size(); ++i) {
      const int32_t lake = levels.lake.data()[i];
      if (lake >= 0 && levels.lakes[static_cast<size_t>(lake)].closed) continue;
      inflow[static_cast<size_t>(end.data()[i])] += lake >= 0 ? -loss : static_cast<double>(runoff.data()[i]);
    }
    std::vector<int> pits(levels.lakes.size(), 0);
    const FlowDirections ground = flow_directions(terrain, sea, {});
    for (size_t i = 0; i < terrain.size(); ++i)
      if (ground.data()[i] == kPit && levels.lake.data()[i] >= 0) ++pits[static_cast<size_t>(levels.lake.data()[i])];
    for (size_t k = 0; k < levels.lakes.size(); ++k) {
      const StandingLake& lake = levels.lakes[k];
      joined += pits[k] > 1 ? 1 : 0;
      overflowing += lake.closed ? 0 : 1;
      if (!lake.closed) {
        ASSERT_EQ(lake.level_m, lake.pass_m);
        ASSERT_GT(lake.outflow, 0.0);
        continue;
      }
      closed_wet += lake.cells > 0 ? 1 : 0;
      double dry = 0.0, least = INFINITY;
      for (size_t i = 0; i < terrain.size(); ++i) {
        if (end.data()[i] != static_cast<int32_t>(k) || levels.lake.data()[i] >= 0) continue;
        dry += static_cast<double>(runoff.data()[i]);
        if (terrain.data()[i] == lake.level_m) least = static_cast<double>(runoff.data()[i]);
      }
      fed += std::abs(dry - inflow[k]) > 1e-6 ? 1 : 0;
      ASSERT_NEAR(lake.inflow, 0.1 * inflow[k], 1e-6 * (1.0 + lake.inflow)) << seed;
      ASSERT_GE(inflow[k] - static_cast<double>(lake.cells) * loss, -1e-6) << seed;
      if (lake.level_m == lake.pass_m) continue;
      ASSERT_TRUE(std::isfinite(least)) << seed;  // the next cell to be flooded drains into this lake
      ASSERT_LT(inflow[k] - least - static_cast<double>(lake.cells + 1) * loss, 1e-6) << seed;
    }
  }
  EXPECT_GT(closed_wet, 1000);
  EXPECT_GT(overflowing, 1000);
  EXPECT_GT(joined, 300);
  EXPECT_GT(fed, 300);
}

TEST(LakeLevels, SameBytesOnAnyNumberOfThreads) {
  const HeightField terrain = rough_terrain(300, 260, 5);
  const RunContext one{.threads = 1}, many{};
  const LakeLevels a = lake_levels(terrain, 0.0F, {.loss_mm_yr = 150.0}, one);
  const LakeLevels b = lake_levels(terrain, 0.0F, {.loss_mm_yr = 150.0}, many);
  EXPECT_EQ(a.lake, b.lake);
  ASSERT_EQ(a.lakes.size(), b.lakes.size());
  for (size_t i = 0; i < a.lakes.size(); ++i) EXPECT_EQ(a.lakes[i].inflow, b.lakes[i].inflow);
}

}  // namespace
}  // namespace seamount::geom
