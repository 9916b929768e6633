// Coarse erosion on fine cells: what was not eroded stays as it was, rivers fall all the way, the sea is left alone.
// That a tile has the bytes of the whole is tested with all operators that look no further than they say
// (tiles/reach_test.cpp).
#include "seamount/ops/erosion/refine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/water/flow.h"
#include "seamount/ops/erosion/coarse_rivers.h"
#include "seamount/ops/erosion/run.h"

namespace seamount::erosion {
namespace {

constexpr int kCells = 384, kTimes = 8;
constexpr double kCell_m = 10.0;

HeightField mountains(uint64_t seed) {
  HeightField made =
      geom::fbm_grid(GridFrame::centred(kCells, kCells, kCell_m), Seed{seed}, {.wavelength_m = 2500}, {});
  for (float& z : made.cells()) z = 150.0F + 600.0F * z;
  return made;
}

struct World {
  HeightField terrain, before;
  Eroded eroded;

  explicit World(uint64_t seed) : terrain(mountains(seed)) {
    before = geom::resample(terrain, GridFrame::centred(kCells / kTimes, kCells / kTimes, kTimes * kCell_m), {});
    eroded = run({before, {}, {}}, {}, {.years = 100000}, Seed{seed}, {});
  }
  CoarseErosion coarse() const { return {before, eroded.terrain, eroded.flow, &eroded.sediment}; }
};

TEST(ErosionRefine, GroundThatWasNotErodedStays) {
  const World world(1);
  const ScalarField no_flow(world.before.frame(), 0.0F);
  const HeightField made =
      refine(world.terrain, {world.before, world.before, no_flow}, {.years = 0, .gullies = 0}, Seed{1}, {});
  for (size_t i = 0; i < made.size(); ++i) ASSERT_NEAR(made.data()[i], world.terrain.data()[i], 1e-3F);
}

TEST(ErosionRefine, KeepsTheShapeOfTheCoarseTerrain) {
  for (const uint64_t seed : {1U, 2U, 3U}) {
    const World world(seed);
    const HeightField made = refine(world.terrain, world.coarse(), {}, Seed{seed}, {});
    const HeightField means = geom::box_downsample(made, kTimes, {});
    double off = 0.0, relief = 0.0;
    for (size_t i = 0; i < means.size(); ++i) {
      off += std::abs(means.data()[i] - world.eroded.terrain.data()[i]);
      relief = std::max(relief, static_cast<double>(std::abs(world.eroded.terrain.data()[i])));
    }
    EXPECT_LT(off / static_cast<double>(means.size()), 0.03 * relief);
  }
}

/// Metres that the ground has to be filled in the beds of the coarse rivers for them to run.
double fill_in_beds(const HeightField& ground, const World& world) {
  const RiverGround rivers =
      river_ground(ground.frame(), world.eroded.terrain, world.eroded.flow, {.least_flow = 20 * 6400.0}, Seed{9}, {});
  const HeightField filled = geom::fill_depressions(ground, 0.0F, {});
  double depth = 0.0;
  for (size_t i = 0; i < ground.size(); ++i)
    if (rivers.distance.data()[i] == 0.0F) depth += filled.data()[i] - ground.data()[i];
  return depth;
}

TEST(ErosionRefine, RiversRunWhereCoarseCellsAloneWouldDamThem) {
  for (const uint64_t seed : {1U, 2U, 3U}) {
    const World world(seed);
    const HeightField made = refine(world.terrain, world.coarse(), {.years = 0, .gullies = 0}, Seed{9}, {});
    HeightField spread = geom::resample(world.eroded.terrain, world.terrain.frame(), {});
    const HeightField before = geom::resample(world.before, world.terrain.frame(), {});
    for (size_t i = 0; i < spread.size(); ++i) spread.data()[i] += world.terrain.data()[i] - before.data()[i];
    EXPECT_LT(fill_in_beds(made, world), 0.1 * fill_in_beds(spread, world));
  }
}

TEST(ErosionRefine, GulliesCutLandAndLeaveTheSeaAlone) {
  const World world(2);
  const auto after = [&](double years) { return refine(world.terrain, world.coarse(), {.years = years}, Seed{2}, {}); };
  const HeightField fresh = after(0), young = after(3000), old = after(20000);
  double cut = 0.0, cut_more = 0.0;
  for (size_t i = 0; i < old.size(); ++i) {
    if (fresh.data()[i] <= 0.0F) {
      ASSERT_EQ(old.data()[i], fresh.data()[i]);
    } else {
      ASSERT_GT(old.data()[i], 0.0F);
    }
    cut += fresh.data()[i] - young.data()[i];
    cut_more += fresh.data()[i] - old.data()[i];
  }
  EXPECT_GT(cut, 0.0);
  EXPECT_GT(cut_more, 2.0 * cut);
  EXPECT_EQ(old, refine(world.terrain, world.coarse(), {.years = 20000}, Seed{2}, {.threads = 1}));
  EXPECT_FALSE(old == refine(world.terrain, world.coarse(), {.years = 20000}, Seed{3}, {}));
}

TEST(ErosionRefine, SaysWhatDoesNotBelongTogether) {
  const World world(1);
  const HeightField other(GridFrame::centred(40, 48, 80.0));
  EXPECT_THROW(refine(world.terrain, {world.before, other, world.eroded.flow}, {}, Seed{1}, {}), IncompatibleInputs);
  EXPECT_THROW(refine(HeightField(GridFrame::centred(20, 20, 160.0)), world.coarse(), {}, Seed{1}, {}),
               IncompatibleInputs);
  EXPECT_THROW(refine(HeightField(GridFrame::centred(20, 20, 1.0)), world.coarse(), {}, Seed{1}, {}),
               IncompatibleInputs);
  EXPECT_THROW(refine(world.terrain, world.coarse(), {.gather_cells = 7}, Seed{1}, {}), InvalidArgument);
}

TEST(RiverGround, AStraightRiverFallsAlongItsBed) {
  HeightField plane(GridFrame::centred(20, 20, 100.0));
  ScalarField flow(plane.frame(), 0.0F);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) plane(x, y) = static_cast<float>(10 * y + 20 * std::abs(x - 10));
  for (int y = 1; y < 19; ++y) flow(10, y) = 1e6F;
  const GridFrame fine = GridFrame::centred(200, 200, 10.0);
  const RiverGround ground =
      river_ground(fine, plane, flow, {.least_flow = 1e5, .side_slope = 0.5, .bend = 0.0}, Seed{1}, {});
  const int column = static_cast<int>(std::lround(fine.column(plane.frame().x(10))));
  for (int y = 20; y < 180; ++y) {
    EXPECT_EQ(ground.distance(column, y), 0.0F);
    EXPECT_GE(ground.highest(column, y), ground.highest(column, y - 1));
    EXPECT_NEAR(ground.highest(column, y), 0.1 * (10 * y - 45), 1.5);
    EXPECT_GT(ground.highest(column + 5, y), ground.highest(column, y));
    EXPECT_EQ(ground.highest(column + 15, y), INFINITY);
  }
}

}  // namespace
}  // namespace seamount::erosion
