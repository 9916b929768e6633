#include "seamount/ops/erosion/beds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/base/rng.h"

namespace seamount::erosion {
namespace {

/// One column of level beds whose top lies at 1000 m.
struct Ground {
  explicit Ground(const LithologyParams& params) : rock(params, Seed{1}), beds(rock, layers.surface.frame(), {}) {
    beds.settle(layers, {}, 0, {});
  }
  Layers layers{HeightField(GridFrame::centred(1, 1, 10), 1000.0F), ScalarField(GridFrame::centred(1, 1, 10), 0.0F),
                ScalarField(GridFrame::centred(1, 1, 10), 0.0F)};
  Lithology rock;
  Beds beds;
};

LithologyParams random_beds(uint64_t seed) {
  Rng random(Seed{seed});
  LithologyParams params{.repeat = seed % 2 == 0, .top_m = 1000};
  for (int i = 0; i < 2 + static_cast<int>(seed % 5); ++i)
    params.beds.push_back({"", 1 + 80 * random.uniform(), std::exp(4 * random.uniform() - 2)});
  return params;
}

/// Integral over height of f(hardness), in steps of 2 cm.
template <class F>
double through(const Lithology& rock, double low, double high, F f) {
  const int steps = std::max(1, static_cast<int>((high - low) / 0.02));
  const double step = (high - low) / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += step * f(rock.hardness(0, 0, low + (i + 0.5) * step));
  return sum;
}

TEST(Beds, AStepCountsEachMetreByItsHardness) {
  for (uint64_t seed = 0; seed < 12; ++seed) {
    const Ground ground(random_beds(seed));
    for (const float top : {1150.0F, 1000.0F, 873.0F, 300.0F}) {
      for (const float rate : {0.01F, 0.5F, 3.0F, 40.0F}) {
        for (const float worn : {0.0F, 7.0F}) {
          const float base = top - 350.0F;
          const float h = ground.beds.cut(0, top, base, worn, rate);
          ASSERT_GE(h, base);
          ASSERT_LE(h, top + rate * worn);
          if (h > top) continue;
          const double needed = through(ground.rock, h, top, [](double hard) { return hard; }) / rate + worn;
          EXPECT_NEAR(needed, h - base, 0.01 * (h - base) + 0.1) << seed << " " << top << " " << rate;
        }
      }
    }
  }
}

TEST(Beds, OneHardnessIsRockWithoutBeds) {
  for (const double hardness : {0.3, 1.0, 5.0}) {
    const Ground ground({.beds = {{"", 3, hardness}, {"", 11, hardness}}, .top_m = 990});
    for (const float rate : {0.2F, 5.0F}) {
      const float own = rate / static_cast<float>(hardness);
      EXPECT_NEAR(ground.beds.cut(0, 1000, 200, 0, rate), (1000 + own * 200) / (1 + own), 0.01);
    }
    const auto own = static_cast<float>(12 * std::sqrt(hardness));
    EXPECT_NEAR(ground.beds.stand(0, 500, 2000, 1000, 12), 500 + own, 0.01);
    EXPECT_NEAR(ground.beds.stand(0, 500, 500, 1000, 12), 500 + own / std::sqrt(2.0F), 0.01);
  }
}

TEST(Beds, ManySequencesAtOnceAreAsOneByOne) {
  // Beds of a metre, cut by kilometres: as thick beds of their mean hardness.
  const Ground thin({.beds = {{"", 0.5, 4}, {"", 0.5, 0.5}}, .top_m = 0});
  for (const float rate : {1.0F, 20.0F}) {
    const float own = rate / 2.25F;
    EXPECT_NEAR(thin.beds.cut(0, 9000, -9000, 0, rate), (9000 - own * 9000) / (1 + own), 2);
  }
}

TEST(Beds, ASlopeStandsAsSteepAsEachBedItPasses) {
  for (uint64_t seed = 0; seed < 12; ++seed) {
    const Ground ground(random_beds(seed));
    for (const float low : {300.0F, 880.0F, 1010.0F}) {
      for (const float rise : {3.0F, 60.0F, 400.0F}) {
        const float h = ground.beds.stand(0, low, 1e6F, 1e5F, rise);
        const auto width = [&](double to) {
          return through(ground.rock, low, to, [&](double hard) { return 1 / (rise * std::sqrt(hard)); });
        };
        EXPECT_NEAR(width(h), 1.0, 0.02) << seed << " " << low << " " << rise;
        // Between two neighbours: (a)^2 + (b)^2 = 1 of the widths from each.
        const float other = low + 0.3F * (h - low), both = ground.beds.stand(0, low, other, 1e5F, rise);
        EXPECT_NEAR(std::pow(width(both), 2) + std::pow(width(both) - width(other), 2), 1.0, 0.04);
        EXPECT_EQ(ground.beds.stand(0, low, other, 0.5F * (low + both), rise), 0.5F * (low + both));
      }
    }
  }
}

TEST(Beds, RiseWithTheRockWhereItRises) {
  const GridFrame frame = GridFrame::centred(2, 1, 10);
  Layers ground{HeightField(frame, 200.0F), ScalarField(frame, 0.0F), ScalarField(frame, 0.0F)};
  Maps site;
  site.uplift = ScalarField(frame, 1.0F);
  site.uplift(1, 0) = 0.5F;
  const Lithology rock({.beds = {{"", 50, 4}, {"", 50, 1}}, .repeat = false, .top_m = 100}, Seed{1});
  Beds beds(rock, frame, {});
  beds.settle(ground, site, 100, {});
  EXPECT_EQ(beds.bed(0, 151), 0);
  EXPECT_EQ(beds.bed(0, 149), 1);
  EXPECT_EQ(beds.bed(1, 101), 0);
  EXPECT_EQ(beds.bed(1, 99), 1);
}

TEST(Beds, TheGridSeesWhatThePlainFunctionSays) {
  const GridFrame frame = GridFrame::centred(40, 30, 50);
  Layers ground{HeightField(frame), ScalarField(frame, 3.0F), ScalarField(frame, 2.0F)};
  Rng random(Seed{5});
  for (float& z : ground.surface.cells()) z = static_cast<float>(600 * random.uniform());
  const Lithology rock({.beds = {{"", 40, 4}, {"", 70, 0.5}, {"", 20, 2}},
                        .top_m = 200,
                        .dip_deg = 12,
                        .strike_deg = 250,
                        .fold_height_m = 100,
                        .fold_wavelength_m = 700,
                        .thickness_variation = 0.3,
                        .faults = {{{{-100, -500}, {60, 600}}, 55, 130}}},
                       Seed{9});
  Beds beds(rock, frame, {});
  beds.settle(ground, {}, 30, {});
  int differ = 0;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      const float bedrock = ground.surface(x, y) - 5.0F;
      differ += beds.bed(static_cast<size_t>(40 * y + x), bedrock) != rock.bed(frame.x(x), frame.y(y), bedrock - 30);
    }
  }
  EXPECT_LE(differ, 2);  // within rounding of a border
}

}  // namespace
}  // namespace seamount::erosion
