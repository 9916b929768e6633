#include "seamount/ops/erosion/rivers.h"

#include <gtest/gtest.h>

#include <cmath>

namespace seamount::erosion {
namespace {

/// A river along a row of cells, with its outlet at x = 0.
struct River {
  Layers ground;
  Drainage drainage;
  Grid<uint8_t> outlets;
  ScalarField discharge, load, level;
  Ledger ledger;

  explicit River(int cells, float height = 0) {
    const GridFrame frame = GridFrame::centred(cells, 1, 100);
    ground = {HeightField(frame, height), ScalarField(frame, 0.0F), ScalarField(frame, 0.0F)};
    for (int x = 0; x < cells; ++x) ground.surface(x, 0) += 0.01F * static_cast<float>(x);
    outlets = Grid<uint8_t>(frame, 0);
    outlets(0, 0) = 1;
    discharge = load = level = ScalarField(frame);
  }
  void step(const Rivers& rivers) {
    drainage.route(ground.surface, outlets, {-1e4F}, {}, level, {});
    gather(drainage, {}, rivers, discharge, {});
    run_rivers(ground, {}, drainage, discharge, rivers, load, level, ledger, {});
  }
};

TEST(Rivers, ReachTheSlopeAtWhichTheyKeepUpWithUplift) {
  // U (1 + G) = K sqrt(Q) S (Yuan et al. 2019, eq. 9 for a runoff of 1). Of n cells that drain through one, the load
  // that it can lay down comes from n - 1.
  for (const double deposition : {0.0, 0.5, 1.0}) {
    River river(60);
    constexpr double kUplift = 5e-4;
    const Rivers rivers{.years = 20000,
                        .erodibility = 1e-5,
                        .debris_ease = 1,
                        .sediment_ease = 1,
                        .deposition = deposition,
                        .sea_m = -1e4};
    for (int i = 0; i < 4000; ++i) {
      for (int x = 1; x < 60; ++x) river.ground.surface(x, 0) += static_cast<float>(kUplift * rivers.years);
      river.step(rivers);
    }
    for (int x = 1; x < 58; ++x) {
      const double cells = 60 - x, rise = kUplift * (1 + deposition * (cells - 1) / cells);
      const double slope = (river.ground.surface(x, 0) - river.ground.surface(x - 1, 0)) / 100;
      EXPECT_NEAR(slope, rise / (1e-5 * std::sqrt(cells * 1e4)), 0.05 * slope) << x << " " << deposition;
    }
  }
}

TEST(Rivers, GatherAllTheRainThatDoesNotEvaporate) {
  River river(50);
  Rivers rivers{.runoff_m_yr = 0.5};
  river.step(rivers);
  EXPECT_FLOAT_EQ(river.discharge(0, 0), 50 * 0.5 * 1e4);
  EXPECT_FLOAT_EQ(river.discharge(49, 0), 0.5 * 1e4);
  rivers.loss_per_km = 0.5;
  river.step(rivers);
  EXPECT_NEAR(river.discharge(0, 0), 0.5e4 * (1 - std::pow(0.95, 50)) / 0.05, 1);
}

TEST(Rivers, CutSoftLayersFasterThanBedrockAndKeepMass) {
  River bare(40, 500), covered(40, 500);
  for (int x = 1; x < 40; ++x) covered.ground.sediment(x, 0) = 30;
  const Rivers rivers{.years = 20000, .erodibility = 1e-5, .sea_m = -1e4};
  for (River* river : {&bare, &covered}) {
    for (int x = 1; x < 40; ++x) river->ground.surface(x, 0) += 2.0F * static_cast<float>(x);
    double before = 0, after = 0;
    for (const float z : river->ground.surface.cells()) before += z;
    river->step(rivers);
    for (const float z : river->ground.surface.cells()) after += z;
    EXPECT_NEAR((before - after) * 1e4, river->ledger.exported, 1e-4 * river->ledger.eroded);
    for (const float s : river->ground.sediment.cells()) EXPECT_GE(s, 0);
  }
  EXPECT_GT(covered.ledger.exported, 1.5 * bare.ledger.exported);
}

TEST(Rivers, FillALakeBeforeTheyLeaveIt) {
  River river(40, 100);
  for (int x = 10; x < 15; ++x) river.ground.surface(x, 0) = 80;
  for (int x = 15; x < 40; ++x) river.ground.surface(x, 0) = 100 + 5 * static_cast<float>(x - 14);
  const Rivers rivers{.years = 1000, .erodibility = 1e-5, .sea_m = -1e4};
  double lake = 0;
  for (int i = 0; i < 400; ++i) {
    const double floor = river.ground.surface(14, 0);
    river.step(rivers);
    EXPECT_GE(river.ground.surface(14, 0), floor - 20);
    lake = river.ground.sediment(14, 0);
  }
  EXPECT_GT(lake, 5);
}

/// A hill on a plain without rivers, `years` of creep in `steps`.
HeightField crept(double years, int steps) {
  const GridFrame frame = GridFrame::centred(101, 101, 10);
  Layers ground{HeightField(frame), ScalarField(frame, 0.0F), ScalarField(frame, 1000.0F)};
  for (int y = 0; y < 101; ++y) {
    for (int x = 0; x < 101; ++x) {
      const double r2 = std::pow(x - 50, 2) + std::pow(y - 50, 2);
      ground.surface(x, y) = static_cast<float>(100 + 20 * std::exp(-0.5 * r2 / 64));
    }
  }
  const Grid<uint8_t> outlets = border_outlets(ground.surface, 50);
  ScalarField discharge(frame), load(frame), level(frame);
  Drainage drainage;
  Ledger ledger;
  const Rivers rivers{.years = years / steps, .deposition = 0, .creep_m2_yr = 1, .sea_m = -1e4, .sweeps = 4};
  for (int i = 0; i < steps; ++i) {
    drainage.route(ground.surface, outlets, {-1e4F}, {}, level, {});
    gather(drainage, {}, rivers, discharge, {});
    run_rivers(ground, {}, drainage, discharge, rivers, load, level, ledger, {});
  }
  return ground.surface;
}

TEST(Rivers, CreepSpreadsAsTheHeatEquationSays) {
  // A Gaussian of variance s^2 + 2 D t, of the same volume. Long steps lag behind.
  const double variance = 6400, later = variance + 2 * 8000, peak = 20 * variance / later;
  const HeightField z = crept(8000, 80), lagging = crept(8000, 8);
  EXPECT_NEAR(z(50, 50) - 100, peak, 0.1 * peak);
  EXPECT_NEAR(z(62, 50) - 100, peak * std::exp(-0.5 * 14400 / later), 0.1 * peak);
  EXPECT_LT(z(50, 50), lagging(50, 50));
  EXPECT_LT(lagging(50, 50), 116);
}

TEST(Rivers, CreepRoundsACrestToTheParabolaThatUpliftAsksFor) {
  // h = U (L^2 - x^2) / (2 D) between two valleys L to either side, whatever the length of the steps.
  constexpr int kHalf = 10;
  constexpr double kUplift = 1e-4, kCreep = 0.02;
  const GridFrame frame = GridFrame::centred(2 * kHalf + 1, 3, 10);
  for (const double years : {500.0, 10000.0}) {
    Layers ground{HeightField(frame, 0.0F), ScalarField(frame, 0.0F), ScalarField(frame, 0.0F)};
    Grid<uint8_t> outlets(frame, 0);
    for (int y = 0; y < 3; ++y) outlets(0, y) = outlets(2 * kHalf, y) = 1;
    ScalarField discharge(frame), load(frame), level(frame);
    Drainage drainage;
    Ledger ledger;
    const Rivers rivers{.years = years,
                        .deposition = 0,
                        .creep_m2_yr = kCreep,
                        .uplift_m = kUplift * years,
                        .sea_m = -1e4,
                        .sweeps = 1};
    for (int i = 0; i < static_cast<int>(3e6 / years); ++i) {
      for (int y = 0; y < 3; ++y) {
        for (int x = 1; x < 2 * kHalf; ++x) ground.surface(x, y) += static_cast<float>(kUplift * years);
      }
      drainage.route(ground.surface, outlets, {-1e4F}, {}, level, {});
      gather(drainage, {}, rivers, discharge, {});
      run_rivers(ground, {}, drainage, discharge, rivers, load, level, ledger, {});
    }
    for (int x = 0; x <= 2 * kHalf; ++x) {
      const double wanted = kUplift * 100 * (kHalf * kHalf - (x - kHalf) * (x - kHalf)) / (2 * kCreep);
      EXPECT_NEAR(ground.surface(x, 1), wanted, 0.05 * kUplift * 100 * kHalf * kHalf / (2 * kCreep))
          << x << " " << years;
    }
  }
}

TEST(Rivers, NothingStandsSteeperOverThemThanItCan) {
  River river(40);
  for (int x = 1; x < 40; ++x) river.ground.surface(x, 0) += 400;
  river.step({.years = 100, .erodibility = 0, .steepest = 0.5, .sea_m = -1e4});
  for (int x = 1; x < 40; ++x) EXPECT_LE(river.ground.surface(x, 0) - river.ground.surface(x - 1, 0), 50.01) << x;
  EXPECT_GT(river.ledger.exported, 0);
}

}  // namespace
}  // namespace seamount::erosion
