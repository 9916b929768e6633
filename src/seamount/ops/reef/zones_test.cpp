// Zones of a reef from the sea to its lagoon, and what lies on them, beside the numbers of nature.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "seamount/ops/reef/cays.h"
#include "seamount/ops/reef/grow.h"
#include "seamount/ops/reef/lagoons.h"
#include "seamount/ops/reef/regions.h"

namespace seamount::reef {
namespace {

constexpr int kSide = 500;
constexpr double kCell_m = 12.0;

/// A platform of 2 km radius on a shelf of 34 m; swell from the east.
Grown platform(uint64_t seed, const GrowParams& changes = {}) {
  Drawing drawing;
  Polygon disc;
  for (int i = 0; i < 90; ++i) {
    const double a = i * std::numbers::pi / 45;
    disc.outer.push_back({2000 * std::cos(a), 2000 * std::sin(a)});
  }
  drawing.areas.push_back({"reef", {disc}});
  const HeightField base(GridFrame::centred(kSide, kSide, kCell_m), -34.0F);
  GrowParams p = changes;
  p.particles = 1;
  p.swell_from_deg = 90;
  p.passes.least_km2 = 1e6;
  p.sand.cays = changes.sand.cays;
  return grow({.terrain = base, .drawing = &drawing}, p, Seed{seed}, {});
}

/// Means over a stretch of coast, from 2800 m east (or west) of the middle inwards, one a cell.
struct Section {
  std::vector<double> z, lagoon, reef;
};

Section section(const Grown& g, int towards) {
  Section s;
  const double half_angle = 0.12;
  for (double r = 2700; r > 100; r -= kCell_m) {
    double z = 0, lagoon = 0, reef = 0;
    constexpr int kRays = 25;
    for (int k = 0; k < kRays; ++k) {
      const double a = half_angle * (2.0 * k / (kRays - 1) - 1.0);
      const GridFrame& f = g.terrain.frame();
      const int x = static_cast<int>(std::lround(f.column(towards * r * std::cos(a))));
      const int y = static_cast<int>(std::lround(f.row(r * std::sin(a))));
      z += static_cast<double>(g.terrain(x, y)) / kRays;
      lagoon += g.labels(x, y) == Region::lagoon ? 1.0 / kRays : 0;
      reef += g.labels(x, y) == Region::reef ? 1.0 / kRays : 0;
    }
    s.z.push_back(z), s.lagoon.push_back(lagoon), s.reef.push_back(reef);
  }
  return s;
}

/// First place from `from` on where z passes a height, upwards or downwards.
size_t passes_height(const std::vector<double>& z, size_t from, double height) {
  const bool below = z[from] < height;
  size_t i = from;
  while (i < z.size() && (z[i] < height) == below) ++i;
  return i;
}

TEST(ReefZones, ComeInOrderWithTheWidthsAndSlopesOfNature) {
  for (const uint64_t seed : {1, 2, 3}) {
    GrowParams p;
    p.sand.cays = 0;
    p.sand.knolls_per_km2 = 0;
    const Grown g = platform(seed, p);
    double slopes[2];
    for (const int towards : {1, -1}) {
      const Section s = section(g, towards);
      const size_t toe = passes_height(s.z, 0, -22.0), shoulder = passes_height(s.z, toe, -5.0);
      const double fore_m = static_cast<double>(shoulder - toe) * kCell_m;
      const double slope = std::atan(17.0 / fore_m) * 180 / std::numbers::pi;
      slopes[towards > 0 ? 0 : 1] = slope;
      EXPECT_GT(slope, 5) << seed << " " << towards;
      EXPECT_LT(slope, 45) << seed << " " << towards;
      const size_t inner = passes_height(s.z, shoulder + 3, -4.0);
      const double flat_m = static_cast<double>(inner - shoulder) * kCell_m;
      EXPECT_GT(flat_m, 50) << "flat";
      EXPECT_LT(flat_m, 1200) << "flat";
      const double crest = *std::max_element(s.z.begin(), s.z.begin() + static_cast<int>(shoulder) + 12);
      EXPECT_GT(crest, towards > 0 ? -1.6 : -2.6);
      EXPECT_LT(crest, 0.3);
      for (size_t i = shoulder + 5; i + 3 < inner; ++i) ASSERT_GT(s.z[i], -4.2) << "no pools on flats, " << seed;
      const size_t floor = passes_height(s.z, inner, -7.0);
      const double back_m = static_cast<double>(floor - inner) * kCell_m;
      EXPECT_LT(back_m, 500) << "back reef";
      EXPECT_GT(back_m, 3.0 / std::tan(26 * std::numbers::pi / 180)) << "back reef";
      for (size_t i = floor + 10; i < s.z.size(); ++i) {
        ASSERT_LT(s.z[i], -4.0) << "lagoon";
        ASSERT_GT(s.z[i], -20.0) << "lagoon";
        ASSERT_GT(s.lagoon[i], 0.7) << "lagoon's label";
      }
      for (size_t i = shoulder + 5; i + 12 < inner; ++i) ASSERT_GT(s.reef[i], 0.7) << "flat's label";
      EXPECT_LT(s.reef[0] + s.lagoon[0], 0.1) << "open sea";
    }
    EXPECT_GT(slopes[0], slopes[1] + 4) << "the lee is gentler";
  }
}

TEST(ReefZones, ThinReefsHaveNoPools) {
  for (const uint64_t seed : {1, 2, 3}) {
    const HeightField base(GridFrame::centred(400, 400, 15), -30.0F);
    GrowParams p;
    p.sand.knolls_per_km2 = 0;
    const Grown g = grow({base}, p, Seed{seed}, {});
    Grid<uint8_t> deep(base.frame(), 0);
    for (size_t i = 0; i < deep.size(); ++i) deep.cells()[i] = g.terrain.cells()[i] < -4 ? 1 : 0;
    double pools = 0, reef = 0;
    for (const RegionOfMask& r : regions_of(deep))
      if (!r.at_edge && r.cells.size() * 225 < 100000) pools += static_cast<double>(r.cells.size());
    for (const float a : g.aggregate.cells()) reef += a > 0.9F ? 1 : 0;
    EXPECT_LT(pools, 0.005 * reef) << seed;
  }
}

TEST(ReefZones, CaysLieInTheLeeAndWideOnesCarryPlants) {
  GrowParams p;
  p.sand.cays = 6;
  int lee = 0, cays = 0, green = 0;
  for (const uint64_t seed : {1, 2, 3, 4}) {
    const Grown g = platform(seed, p);
    Grid<uint8_t> dry(g.terrain.frame(), 0);
    for (size_t i = 0; i < dry.size(); ++i) dry.cells()[i] = g.terrain.cells()[i] > 0.3F ? 1 : 0;
    for (const RegionOfMask& r : regions_of(dry)) {
      if (r.cells.size() < 3) continue;
      double x = 0;
      bool plants = false;
      float top = 0;
      for (const int64_t i : r.cells) {
        x += g.terrain.frame().x(static_cast<int>(i % kSide)) / static_cast<double>(r.cells.size());
        top = std::max(top, g.terrain.cells()[static_cast<size_t>(i)]);
        const Region label = g.labels.cells()[static_cast<size_t>(i)];
        ASSERT_TRUE(label == Region::beach || label == Region::mountain);
        plants = plants || label == Region::mountain;
      }
      ++cays;
      lee += x < -200 ? 1 : 0;
      EXPECT_LT(x, 800) << "none to windward";
      green += plants ? 1 : 0;
      EXPECT_LT(top, 3.6F);
      const double area_m2 = static_cast<double>(r.cells.size()) * kCell_m * kCell_m;
      if (plants) {
        EXPECT_GT(area_m2, 2000) << "small banks are bare";
      }
    }
  }
  EXPECT_GE(cays, 8);
  EXPECT_GE(lee, 0.7 * cays);
  EXPECT_GE(green, 2);
  EXPECT_LT(green, cays);
}

TEST(ReefZones, KnollsAreManySmallAndFewLarge) {
  const GridFrame frame = GridFrame::centred(600, 600, 10);
  const ScalarField inside(frame, 1000.0F), crowd(frame, 1.0F);
  const ScalarField knolls = scatter_knolls(inside, inside, crowd, 8, Seed{3});
  Grid<uint8_t> mask(frame, 0);
  for (size_t i = 0; i < mask.size(); ++i) mask.cells()[i] = knolls.cells()[i] > 0 ? 1 : 0;
  int small = 0, large = 0;
  for (const RegionOfMask& r : regions_of(mask)) (r.cells.size() < 40 ? small : large) += 1;
  EXPECT_GT(small, 3 * large);
  EXPECT_GT(large, 2);
  const ScalarField flat(frame, -1.0F);
  EXPECT_TRUE(scatter_knolls(inside, flat, crowd, 8, Seed{3}).empty()) << "none on flats";
}

TEST(ReefZones, GroovesAreWindwardAndOnlyWhereCellsResolveThem) {
  GrowParams with, without;
  with.sand.cays = without.sand.cays = 0;
  without.detail.grooves_m = 0;
  const Grown a = platform(1, with), b = platform(1, without);
  double windward = 0, lee = 0;
  float deepest = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double d = std::abs(static_cast<double>(a.terrain(x, y)) - static_cast<double>(b.terrain(x, y)));
      if (x > kSide * 3 / 4) windward += d;
      if (x < kSide / 4) lee += d;
      deepest = std::max(deepest, static_cast<float>(d));
    }
  }
  EXPECT_GT(windward, 500);
  EXPECT_LT(lee, 0.02 * windward);
  EXPECT_LT(deepest, 8.0F);
  // From spur to spur along the windward side, where they stand out most at each bearing.
  int turns = 0;
  double before = 0;
  for (double angle = -0.6; angle < 0.6; angle += 0.002) {
    double most = 0;
    for (double r = 1900; r < 2150; r += 6) {
      const GridFrame& f = a.terrain.frame();
      const int x = static_cast<int>(std::lround(f.column(r * std::cos(angle))));
      const int y = static_cast<int>(std::lround(f.row(r * std::sin(angle))));
      const double d = static_cast<double>(a.terrain(x, y)) - static_cast<double>(b.terrain(x, y));
      if (std::abs(d) > std::abs(most)) most = d;
    }
    if (std::abs(most) < 0.3) continue;
    turns += most * before < 0 ? 1 : 0;
    before = most;
  }
  const double spacing_m = 2.0 * 1.2 * 2030 / turns;
  EXPECT_GT(spacing_m, 55);
  EXPECT_LT(spacing_m, 125);
  HeightField coarse(GridFrame::centred(60, 60, 120), -30.0F);
  EXPECT_TRUE(grow({coarse}, with, Seed{1}, {}).terrain == grow({coarse}, without, Seed{1}, {}).terrain);
}

}  // namespace
}  // namespace seamount::reef
