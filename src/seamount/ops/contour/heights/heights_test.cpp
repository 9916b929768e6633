#include "seamount/ops/contour/heights/heights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/contour/growth/grow.h"
#include "seamount/ops/contour/growth/test_network.h"

namespace seamount::contour {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const GridFrame kDomain = GridFrame::centred(100, 80, 10);

Ring blob(double radius, Vec2 centre = {}, double wobble = 0.1, double phase = 0.0) {
  Ring ring;
  for (int i = 0; i < 90; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 90;
    const double r = radius * (1.0 + wobble * std::sin(3.0 * a + phase));
    ring.push_back(centre + Vec2{r * std::cos(a), r * std::sin(a)});
  }
  return ring;
}

Tin grown(const std::vector<RegionOutline>& outlines, int particles = 4000, uint64_t seed = 3) {
  GrowParams params;
  params.particles = particles;
  return grow(regions_from_outlines(outlines, kDomain, "outlines"), kDomain, nullptr, {}, params, Seed{seed}, {});
}

std::string message(const Tin& tin, const HeightsParams& params, const HeightField* terrain = nullptr) {
  try {
    heights(tin, terrain, params, {});
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Largest difference of the two distribution functions.
double kolmogorov(std::vector<double> z, const HeightDistribution& distribution) {
  std::sort(z.begin(), z.end());
  double worst = 0.0;
  for (size_t i = 0; i < z.size(); ++i) {
    const double share = distribution.share_below(z[i]);
    const auto n = static_cast<double>(z.size());
    worst = std::max(
        {worst, std::abs(share - static_cast<double>(i) / n), std::abs(share - static_cast<double>(i + 1) / n)});
  }
  return worst;
}

std::vector<double> land_heights(const Tin& tin, double from = -1e9, double to = 1e9) {
  std::vector<double> z;
  for (size_t i = 0; i < tin.nodes.size(); ++i) {
    const auto h = static_cast<double>(tin.height_m[i]);
    if (tin.region[i] >= 0 && h > from && h < to) z.push_back(h);
  }
  return z;
}

TEST(Distribution, QuantilesInvertShares) {
  const auto d = HeightDistribution::from_bins({1, 0, 3, 4}, 100, 500, "histogram");
  EXPECT_DOUBLE_EQ(d.share_below(100), 0.0);
  EXPECT_DOUBLE_EQ(d.share_below(200), 0.125);
  EXPECT_DOUBLE_EQ(d.share_below(300), 0.125);
  EXPECT_DOUBLE_EQ(d.share_below(400), 0.5);
  EXPECT_DOUBLE_EQ(d.quantile(100, 500, 0.5), 400);
  EXPECT_DOUBLE_EQ(d.quantile(100, 500, 0.0625), 150);
  EXPECT_DOUBLE_EQ(d.quantile(300, 500, 3.0 / 7.0), 400);
  EXPECT_DOUBLE_EQ(d.quantile(100, 500, 1.0), 500);
  EXPECT_DOUBLE_EQ(d.quantile(220, 260, 0.25), 230);  // no ground there: evenly
  EXPECT_DOUBLE_EQ(d.quantile(0, 80, 0.25), 20);      // nor beyond
  double previous = 0.0;
  for (int i = 1; i < 1000; ++i) {
    const double z = d.quantile(100, 500, i / 1000.0);
    EXPECT_GT(z, previous);
    EXPECT_NEAR(d.share_below(z), i / 1000.0, 1e-12);
    previous = z;
  }
}

TEST(Distribution, LandformsAreDistributions) {
  for (size_t i = 0; i < Choices<Landform>::names.size(); ++i) {
    const auto d = HeightDistribution::of_landform(static_cast<Landform>(i), -50, 900);
    EXPECT_EQ(d.quantile(-50, 900, 0.0), -50);
    EXPECT_NEAR(d.quantile(-50, 900, 1.0), 900, 1e-9);
    EXPECT_NEAR(d.share_below(d.quantile(-50, 900, 0.3)), 0.3, 1e-9);
  }
}

TEST(Distribution, TerrainsAreMeasured) {
  HeightField terrain(GridFrame::centred(100, 10, 1));
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 100; ++x) terrain(x, y) = static_cast<float>(x < 40 ? 0 : x);
  }
  const MeasuredHeights all = measure_heights(terrain, -HUGE_VAL, 10);
  EXPECT_EQ(all.low_m, 0);
  EXPECT_EQ(all.high_m, 99);
  EXPECT_EQ(all.bins[0], 400);
  const MeasuredHeights land = measure_heights(terrain, 1, 10);
  EXPECT_EQ(land.low_m, 40);
  EXPECT_THROW(measure_heights(terrain, 500, 10), IncompatibleInputs);
  EXPECT_THROW(measure_heights(HeightField(kDomain, 5.0F), -HUGE_VAL, 10), IncompatibleInputs);
}

TEST(Heights, QuantilesMatchTheHistogramInTheOrderOfRanks) {
  const Tin tin = grown({{"isle", blob(300), {}, false}});
  HeightsParams params;
  params.min_m = 0;
  params.max_m = 800;
  params.outlines = Outlines::loose;
  params.spikes = Spikes::keep;
  for (const std::vector<double>& histogram : {std::vector<double>{1, 1}, {5, 2, 1, 0, 1}, {0, 1, 8, 1, 2, 2}}) {
    params.histogram = histogram;
    const Tin made = heights(tin, nullptr, params, {});
    EXPECT_LT(kolmogorov(land_heights(made), HeightDistribution::from_bins(histogram, 0, 800, "")), 1.01e-3);
    for (size_t i = 0; i + 1 < made.nodes.size(); ++i) {
      if (made.region[i] < 0 || made.region[i + 1] < 0) continue;
      EXPECT_EQ(made.rank[i] < made.rank[i + 1], made.height_m[i] < made.height_m[i + 1]);
    }
    EXPECT_EQ(endorheic(made), 0);
    EXPECT_EQ(made.rank, tin.rank);
  }
  // Following the outline changes the lowest nodes alone.
  params.outlines = Outlines::follow;
  const Tin made = heights(tin, nullptr, params, {});
  EXPECT_LT(kolmogorov(land_heights(made), HeightDistribution::from_bins(params.histogram, 0, 800, "")), 0.05);
}

TEST(Heights, RegionsOfOneDepthRiseTogether) {
  const Tin tin = grown({{"isle", blob(370), {}, false},
                         {"west", blob(140, {-170, 0}), {}, false},
                         {"east", blob(70, {170, 0}), {}, false}});
  HeightsParams params;
  params.histogram = {1, 3, 2, 1};
  params.min_m = 0;
  params.max_m = 1000;
  params.outlines = Outlines::loose;
  params.spikes = Spikes::keep;
  const Tin made = heights(tin, nullptr, params, {});
  EXPECT_LT(kolmogorov(land_heights(made), HeightDistribution::from_bins(params.histogram, 0, 1000, "")), 2e-3);
  std::vector<float> top(3, 0.0F);
  for (size_t i = 0; i < made.nodes.size(); ++i) {
    if (made.region[i] >= 0) top[at(made.region[i])] = std::max(top[at(made.region[i])], made.height_m[i]);
  }
  EXPECT_GT(top[1], top[2] + 50);  // the wider range is higher
  params.summits = Summits::equal;
  const Tin equal = heights(tin, nullptr, params, {});
  for (size_t i = 0; i < made.nodes.size(); ++i) {
    if (made.region[i] == 2) top[2] = std::max(top[2], equal.height_m[i]);
  }
  EXPECT_GT(top[2], 990);
}

std::vector<RegionOutline> mountains() {
  return {{"isle", blob(380), 0.0, false},
          {"high", blob(140, {-170, 0}), 400.0, false},
          {"peak", blob(60, {-170, 10}), 700.0, false},
          {"low", blob(90, {180, 40}), 150.0, false},
          {"crater", blob(40, {180, 40}), {}, true},
          {"tarn", blob(30, {0, -200}), 60.0, true}};
}

TEST(Heights, OutlinesOfGivenHeightAreHonoured) {
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    const Tin tin = grown(mountains(), 3000, seed);
    for (const Outlines outlines : {Outlines::follow, Outlines::loose}) {
      HeightsParams params;
      params.max_m = 1000;
      params.outlines = outlines;
      const Tin made = heights(tin, nullptr, params, {});
      EXPECT_EQ(dishonoured(made), 0) << seed;
      EXPECT_EQ(endorheic(made), 0) << seed;
    }
  }
}

TEST(Heights, ContoursFollowTheirOutlines) {
  const Tin tin = grown(mountains(), 6000);
  const auto worst = [&](Outlines outlines) {
    HeightsParams params;
    params.max_m = 1000;
    params.outlines = outlines;
    const Tin made = heights(tin, nullptr, params, {});
    std::vector<double> away;
    for (const auto& t : made.triangles) {  // where the contour at sea level crosses sides
      for (size_t k = 0; k < 3; ++k) {
        const size_t a = at(t[k]);
        const size_t b = at(t[(k + 1) % 3]);
        const auto za = static_cast<double>(made.height_m[a]);
        const auto zb = static_cast<double>(made.height_m[b]);
        if ((za >= 0) == (zb >= 0)) continue;
        const Vec2 p = made.nodes[a] + za / (za - zb) * (made.nodes[b] - made.nodes[a]);
        double nearest = 1e9;
        const Ring dense = geom::densify(tin.regions[0].outline, 0.5);
        for (const Vec2 q : dense) nearest = std::min(nearest, std::hypot(p.x - q.x, p.y - q.y));
        away.push_back(nearest);
      }
    }
    std::sort(away.begin(), away.end());
    return away[away.size() * 9 / 10];
  };
  EXPECT_LT(worst(Outlines::follow), 0.6);  // nodes lie 7 m apart
  EXPECT_GT(worst(Outlines::loose), 1.5);
}

TEST(Heights, GroundBetweenOutlinesFollowsItsPartOfTheHistogram) {
  const Tin tin = grown({{"isle", blob(380), 0.0, false}, {"high", blob(220), 300.0, false}}, 8000);
  HeightsParams params;
  params.histogram = {4, 1, 1, 1, 1, 3};
  params.max_m = 600;
  params.outlines = Outlines::loose;
  params.spikes = Spikes::keep;
  const Tin made = heights(tin, nullptr, params, {});
  EXPECT_LT(kolmogorov(land_heights(made, 0, 300), HeightDistribution::from_bins({4, 1, 1}, 0, 300, "")), 0.02);
  EXPECT_LT(kolmogorov(land_heights(made, 300), HeightDistribution::from_bins({1, 1, 3}, 300, 600, "")), 0.02);
}

TEST(Heights, BasinsLieBelowTheirOutlines) {
  const Tin tin =
      grown({{"isle", blob(380), 0.0, false}, {"hill", blob(250), 300.0, false}, {"crater", blob(90), {}, true}});
  HeightsParams params;
  params.max_m = 600;
  params.basin_depth_m = 80;
  const Tin made = heights(tin, nullptr, params, {});
  float low = 1e9F;
  for (size_t i = 0; i < made.nodes.size(); ++i) {
    if (made.region[i] != 2) continue;
    EXPECT_LE(made.height_m[i], 300.0F);
    low = std::min(low, made.height_m[i]);
  }
  EXPECT_NEAR(low, 220, 5);
}

TEST(Heights, PeaksAreReachedAndNoMore) {
  const Tin tin = grown({{"isle", blob(380), 0.0, false, {}},
                         {"high", blob(100, {-170, 0}), 200.0, false, 520.0},
                         {"low", blob(100, {170, 0}), 200.0, false, 260.0},
                         {"pit", blob(40, {170, 0}), 240.0, true, 190.0}});
  HeightsParams params;
  params.max_m = 600;
  const Tin made = heights(tin, nullptr, params, {});
  std::vector<float> top(4, -1e9F);
  float deepest = 1e9F;
  for (size_t i = 0; i < made.nodes.size(); ++i) {
    if (made.region[i] < 0) continue;
    top[at(made.region[i])] = std::max(top[at(made.region[i])], made.height_m[i]);
    if (made.region[i] == 3) deepest = std::min(deepest, made.height_m[i]);
  }
  EXPECT_NEAR(top[1], 520, 8);
  EXPECT_NEAR(top[2], 260, 8);
  EXPECT_NEAR(deepest, 190, 3);
  EXPECT_EQ(dishonoured(made), 0);
  params.max_m = 500;
  EXPECT_THAT(message(tin, params), HasSubstr("the peak of 'high' lies at 520 m"));
}

/// How many nodes of the land stand more than `steep` (m/m) above a neighbour, and the steepest.
std::pair<int, double> steep_nodes(const Tin& tin, double steep) {
  int count = 0;
  double most = 0.0;
  for (const auto& t : tin.triangles) {
    for (size_t k = 0; k < 3; ++k) {
      const size_t a = at(t[k]);
      const size_t b = at(t[(k + 1) % 3]);
      if (tin.region[a] < 0 || tin.region[b] < 0) continue;
      const Vec2 d = tin.nodes[b] - tin.nodes[a];
      const double slope =
          std::abs(static_cast<double>(tin.height_m[b]) - static_cast<double>(tin.height_m[a])) / std::sqrt(dot(d, d));
      most = std::max(most, slope);
      if (slope > steep) ++count;
    }
  }
  return {count, most};
}

TEST(Heights, NoSpikesAndTheRestStays) {
  for (const Landform landform : {Landform::mountain, Landform::coastal, Landform::volcano, Landform::canyon}) {
    for (uint64_t seed = 1; seed <= 6; ++seed) {
      const Tin tin = grown({{"isle", blob(380), 0.0, false}}, 5000, seed);
      HeightsParams params;
      params.landform = landform;
      params.max_m = 120;
      const Tin cut = heights(tin, nullptr, params, {});
      params.spikes = Spikes::keep;
      const Tin kept = heights(tin, nullptr, params, {});
      EXPECT_EQ(endorheic(cut), 0) << seed;
      EXPECT_EQ(dishonoured(cut), 0) << seed;
      double squares = 0.0;
      double sides = 0.0;
      double lost = 0.0;
      for (size_t i = 0; i < tin.nodes.size(); ++i) lost += static_cast<double>(kept.height_m[i] - cut.height_m[i]);
      for (const auto& t : kept.triangles) {
        for (size_t k = 0; k < 3; ++k) {
          const size_t a = at(t[k]);
          const size_t b = at(t[(k + 1) % 3]);
          if (tin.region[a] < 0 || tin.region[b] < 0) continue;
          const Vec2 d = tin.nodes[b] - tin.nodes[a];
          const auto rise = static_cast<double>(kept.height_m[b] - kept.height_m[a]);
          squares += rise * rise / dot(d, d);
          sides += 1.0;
        }
      }
      // A triangle's slope is the root of 2 times that of its sides, on the mean over directions.
      const double usual = std::sqrt(2.0 * squares / sides);
      EXPECT_LT(steep_nodes(cut, 2.6 * usual).first, 40) << seed;
      EXPECT_LT(steep_nodes(cut, 0.0).second, 5.0 * usual) << seed;
      EXPECT_LT(lost / static_cast<double>(tin.nodes.size()), 0.03 * 120) << seed;
    }
  }
}

TEST(Heights, TheSeaFallsFromTheCoast) {
  const Tin tin = grown({{"isle", blob(300), 0.0, false}});
  const Tin made = heights(tin, nullptr, {}, {});
  for (size_t i = 0; i < made.nodes.size(); ++i) {
    EXPECT_TRUE(std::isfinite(made.height_m[i]));
    EXPECT_EQ(made.height_m[i] > 0.0F, made.region[i] >= 0) << i;
  }
}

TEST(Heights, MeasuredTerrainsGiveTheirDistribution) {
  HeightField terrain(GridFrame::centred(64, 64, 5));
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) terrain(x, y) = static_cast<float>(std::hypot(x - 30, y - 33));
  }
  const Tin made = heights(grown({{"isle", blob(300), {}, false}}), &terrain, {}, {});
  const MeasuredHeights m = measure_heights(terrain, -HUGE_VAL, 4096);
  const auto d = HeightDistribution::from_bins(m.bins, m.low_m, m.high_m, "");
  EXPECT_LT(kolmogorov(land_heights(made), d), 0.02);
}

TEST(Heights, MessagesSayWhatToDo) {
  const Tin tin = grown({{"isle", blob(300), 0.0, false}, {"hill", blob(100), 200.0, false}}, 1000);
  HeightsParams params;
  params.histogram = {0, 0, 0};
  EXPECT_THAT(message(tin, params), HasSubstr("histogram: all bins are 0"));
  params.histogram = {1, -2};
  EXPECT_THAT(message(tin, params), HasSubstr("histogram: -2 is outside [0, inf)"));
  params.histogram = {1, 2};
  params.density = {{{0, 1}, {1, 1}}};
  EXPECT_THAT(message(tin, params), HasSubstr("histogram: given together with density"));
  params = {};
  params.density = {{{0.5, 1}}};
  EXPECT_THAT(message(tin, params), HasSubstr("density: a density needs at least two knots"));
  params.density = {{{0, 1}, {800, 1}}};
  EXPECT_THAT(message(tin, params), HasSubstr("x = 800 is outside [0, 1]"));
  params.density = {{{0, 0}, {1, 0}}};
  EXPECT_THAT(message(tin, params), HasSubstr("density: all bins are 0"));
  params = {};
  params.min_m = 500;
  params.max_m = 400;
  EXPECT_THAT(message(tin, params), HasSubstr("max_m: the highest height 400 m is not above the lowest, 500 m"));
  params.min_m = 0;
  params.max_m = 150;
  EXPECT_THAT(message(tin, params), AllOf(HasSubstr("max_m: the outline of 'hill' lies at 200 m"), HasSubstr("raise")));
  params.min_m = 20;
  params.max_m = 500;
  EXPECT_THAT(message(tin, params), AllOf(HasSubstr("min_m: the outline of 'isle' lies at 0 m"), HasSubstr("lower")));
  EXPECT_THAT(message(Tin{}, {}), HasSubstr("make it with contour.grow"));
}

}  // namespace
}  // namespace seamount::contour
