#include "seamount/ops/reef/aggregate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace seamount::reef {
namespace {

Grid<uint8_t> open_sea(int side) { return Grid<uint8_t>(GridFrame::centred(side, side, 1.0), 1); }

double radius_of(LatticeCell s, LatticeCell centre) { return std::hypot(s.x - centre.x, s.y - centre.y); }

WalkRules rules_for(int particles) {
  WalkRules rules;
  rules.particles = particles;
  rules.max_steps = int64_t{1} << 50;
  return rules;
}

/// Slope of log N(r) over log r, from 8 cells to the radius of gyration.
double mass_radius_dimension(const Aggregate& grown, LatticeCell centre) {
  double square = 0;
  for (const LatticeCell s : grown.cells) square += std::pow(radius_of(s, centre), 2);
  const double gyration = std::sqrt(square / static_cast<double>(grown.cells.size()));
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (double r = 8; r < gyration; r *= 1.15) {
    const auto mass =
        std::count_if(grown.cells.begin(), grown.cells.end(), [&](LatticeCell s) { return radius_of(s, centre) <= r; });
    const double x = std::log(r), y = std::log(static_cast<double>(mass));
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

TEST(Aggregate, HasTheFractalDimensionOfLatticeAggregates) {
  const Grid<uint8_t> sea = open_sea(1200);
  const LatticeCell centre{600, 600};
  double sum = 0;
  constexpr int kSeeds = 8;
  for (uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Aggregate grown = aggregate(sea, {centre}, rules_for(12000), Seed{seed}, {});
    ASSERT_EQ(grown.cells.size(), 12001U);
    EXPECT_EQ(grown.lost, 0);
    const double dimension = mass_radius_dimension(grown, centre);
    sum += dimension;
    EXPECT_NEAR(dimension, 1.71, 0.12) << "seed " << seed;
  }
  EXPECT_NEAR(sum / kSeeds, 1.71, 0.05);
}

/// Every particle touches an earlier one, no cell is taken twice, all lie in the habitat.
void expect_grown_on(const Grid<uint8_t>& habitat, const Aggregate& grown, size_t kernels) {
  Grid<uint8_t> taken(habitat.frame(), 0);
  for (size_t i = 0; i < grown.cells.size(); ++i) {
    const LatticeCell s = grown.cells[i];
    ASSERT_TRUE(habitat.contains(s.x, s.y));
    EXPECT_NE(habitat(s.x, s.y), 0);
    EXPECT_EQ(taken(s.x, s.y), 0) << "taken twice";
    int touching = 0;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (taken.contains(s.x + dx, s.y + dy)) touching += taken(s.x + dx, s.y + dy);
      }
    }
    if (i >= kernels) {
      EXPECT_GT(touching, 0) << "particle " << i;
    }
    taken(s.x, s.y) = 1;
  }
}

TEST(Aggregate, ParticlesTouchWhatGrewBeforeAndStayInTheHabitat) {
  Grid<uint8_t> habitat = open_sea(90);
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 30; ++x) habitat(x, y) = 0;
  }
  for (const Launch launch : {Launch::ring, Launch::anywhere}) {
    for (const double drift : {0.0, 0.15}) {
      WalkRules rules = rules_for(700);
      rules.max_steps = 200000;
      rules.launch = launch;
      rules.drift = {drift, -drift};
      rules.stickiness = 0.5;
      const std::vector<LatticeCell> kernels = {{40, 40}, {70, 20}, {70, 21}};
      const Aggregate grown = aggregate(habitat, kernels, rules, Seed{3}, {});
      EXPECT_EQ(grown.cells.size() + static_cast<size_t>(grown.lost), 703U);
      EXPECT_GT(grown.cells.size(), 100U);
      expect_grown_on(habitat, grown, kernels.size());
    }
  }
}

TEST(Aggregate, GrowsAgainstTheCurrentThatBringsTheParticles) {
  const Grid<uint8_t> sea = open_sea(400);
  double upstream = 0;
  for (uint64_t seed = 0; seed < 5; ++seed) {
    WalkRules rules = rules_for(1500);
    rules.drift = {0.1, 0.0};  // to the east
    const Aggregate grown = aggregate(sea, {{200, 200}}, rules, Seed{seed}, {});
    for (const LatticeCell s : grown.cells) upstream += s.x < 200 ? 1 : 0;
  }
  EXPECT_GT(upstream / (5 * 1500), 0.7);
}

TEST(Aggregate, LowStickinessGrowsThicker) {
  const Grid<uint8_t> sea = open_sea(400);
  const auto gyration = [&](double stickiness) {
    WalkRules rules = rules_for(3000);
    rules.stickiness = stickiness;
    const Aggregate grown = aggregate(sea, {{200, 200}}, rules, Seed{1}, {});
    double square = 0;
    for (const LatticeCell s : grown.cells) square += std::pow(radius_of(s, {200, 200}), 2);
    return std::sqrt(square / static_cast<double>(grown.cells.size()));
  };
  EXPECT_LT(gyration(0.05), 0.8 * gyration(1.0));
}

TEST(Aggregate, BoundedWalksAreLostAndFullHabitatIsFilled) {
  WalkRules rules = rules_for(50);
  rules.max_steps = 1;
  EXPECT_GT(aggregate(open_sea(200), {{100, 100}}, rules, Seed{1}, {}).lost, 40);
  rules = rules_for(24);
  rules.launch = Launch::anywhere;
  const Aggregate full = aggregate(open_sea(5), {{2, 2}}, rules, Seed{1}, {});
  EXPECT_EQ(full.cells.size(), 25U);
  EXPECT_EQ(aggregate(open_sea(1), {{0, 0}}, rules_for(0), Seed{1}, {}).cells.size(), 1U);
}

TEST(Aggregate, ReachableHabitatEndsAtGaps) {
  Grid<uint8_t> habitat(GridFrame::centred(9, 1, 1.0), 1);
  habitat(3, 0) = 0;
  EXPECT_EQ(reachable_habitat(habitat, {{0, 0}}), 3);
  EXPECT_EQ(reachable_habitat(habitat, {{8, 0}}), 5);
}

}  // namespace
}  // namespace seamount::reef
