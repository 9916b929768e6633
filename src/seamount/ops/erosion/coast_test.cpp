#include "seamount/ops/erosion/coast.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace seamount::erosion {
namespace {

/// Land in the west that ends in a cliff, a sea floor that falls to the east.
Layers cliff(float height) {
  const GridFrame frame = GridFrame::centred(120, 80, 20);
  Layers ground{HeightField(frame), ScalarField(frame, 0.0F), ScalarField(frame, 0.0F)};
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 120; ++x) ground.surface(x, y) = x < 40 ? height : -2.0F - 0.5F * static_cast<float>(x - 40);
  }
  return ground;
}

double sum(const ScalarField& field) { return std::accumulate(field.cells().begin(), field.cells().end(), 0.0); }

TEST(Coast, WavesTakeACliffBackAtTheirRate) {
  Layers ground = cliff(30);
  ScalarField load(ground.frame(), 0.0F), room(ground.frame());
  Ledger ledger;
  const double before = sum(ground.surface);
  // A straight coast is half as exposed as a headland: 10 m of 20 m a year, so 1000 years take ten cells of 20 m.
  const Coast coast{.years = 20, .retreat_m_yr = 0.4};
  for (int i = 0; i < 50; ++i) run_coast(ground, {}, coast, load, room, ledger, {});
  int land = 0;
  while (ground.surface(land, 40) > 0) ++land;
  EXPECT_NEAR(land, 30, 3);
  EXPECT_NEAR((before - sum(ground.surface)) * 400, ledger.exported, 1e-4 * ledger.eroded);
}

TEST(Coast, ARiverMouthGrowsASmoothDelta) {
  Layers ground = cliff(30);
  ScalarField load(ground.frame(), 0.0F), room(ground.frame());
  Ledger ledger;
  const double before = sum(ground.surface);
  load(41, 40) = 4000;
  run_coast(ground, {}, {.settling_m = 400}, load, room, ledger, {});
  EXPECT_NEAR((sum(ground.surface) - before) * 400 + ledger.exported, 4000.0 * 400, 100);
  EXPECT_GT(ground.sediment(48, 40), ground.sediment(48, 60));
  for (int y = 1; y < 79; ++y) {
    for (int x = 41; x < 119; ++x) {
      ASSERT_LE(ground.surface(x, y), 0.11F);
      ASSERT_LT(std::abs(ground.sediment(x, y) - ground.sediment(x, y + 1)), 3) << "no spikes";
    }
  }
  EXPECT_EQ(ground.sediment(20, 40), 0);
}

TEST(Coast, WhatSettlesLeavesAnOpenShelfThatFallsSeawardAndFillsBays) {
  Layers ground = cliff(30);
  for (int y = 30; y < 50; ++y) {
    for (int x = 10; x < 40; ++x) ground.surface(x, y) = -20;  // a bay 400 m wide and 600 m long
  }
  ScalarField load(ground.frame(), 0.0F), room(ground.frame());
  Ledger ledger;
  for (int step = 0; step < 300; ++step) {
    load = ScalarField(ground.frame(), 0.0F);
    for (int y = 0; y < 80; ++y) load(41, y) = 2;
    for (int y = 32; y < 48; ++y) load(12, y) = 4;
    run_coast(ground, {}, {.settling_m = 300}, load, room, ledger, {});
  }
  int shore = 119;
  while (ground.surface(shore, 10) < 0) --shore;
  EXPECT_LE(shore, 45) << "deltas end where waves keep the floor free";
  for (const int x : {60, 70, 80}) {
    const float from_shore = 20.0F * static_cast<float>(x - shore);
    EXPECT_LT(ground.surface(x, 10), 0.11F - 0.1F * std::cbrt(from_shore * from_shore)) << "Dean's profile, x " << x;
  }
  EXPECT_GT(ground.surface(60, 10), -10) << "22 m deep before";
  EXPECT_GT(ground.surface(14, 40), -1.5F) << "the bay's head is filled";
}

}  // namespace
}  // namespace seamount::erosion
