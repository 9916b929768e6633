#include "seamount/ops/hydrology/distribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/base/rng.h"
#include "seamount/ops/hydrology/bearings.h"
#include "seamount/ops/hydrology/tally.h"

namespace seamount::hydrology {
namespace {

std::vector<float> heavy_tailed(int count, uint64_t seed, float middle, float scale) {
  Rng rng{Seed{seed}};
  std::vector<float> values(static_cast<size_t>(count));
  for (float& value : values) value = middle + scale * static_cast<float>(std::tan(rng.uniform(-1.5, 1.5)));
  return values;
}

Distribution tallied(const std::vector<float>& values, float origin, int threads = 1, bool whole = false) {
  RunContext run;
  run.threads = threads;
  return gather(
      Tally(origin, whole), static_cast<int64_t>(values.size()), [](int64_t) { return true; },
      [&](int64_t i) { return values[static_cast<size_t>(i)]; }, run);
}

TEST(Distribution, MomentsAndQuantilesAreThoseOfTheValues) {
  for (const float scale : {1e-4F, 1.0F, 1e4F}) {
    const std::vector<float> values = heavy_tailed(400'000, 3, 7 * scale, scale);
    const Distribution binned = tallied(values, 0.0F, 3);
    const Distribution exact(std::vector<double>(values.begin(), values.end()));
    EXPECT_EQ(binned.count(), exact.count());
    EXPECT_EQ(binned.low(), exact.low());
    EXPECT_EQ(binned.high(), exact.high());
    EXPECT_NEAR(binned.mean(), exact.mean(), 1e-9 * scale);
    EXPECT_NEAR(binned.deviation(), exact.deviation(), 1e-9 * exact.deviation());
    for (const double share : {0.0, 0.001, 0.05, 0.5, 0.95, 0.999, 1.0}) {
      const double value = exact.quantile(share);
      EXPECT_NEAR(binned.quantile(share), value, std::abs(value) / 256.0 + 1e-9) << share;
      EXPECT_NEAR(binned.up_to(value), exact.up_to(value), 5e-3) << share;
    }
  }
}

TEST(Distribution, AnyNumberOfThreadsGivesTheSameBits) {
  const std::vector<float> values = heavy_tailed(400'000, 5, 0.0F, 1.0F);
  const Distribution one = tallied(values, 0.0F, 1), many = tallied(values, 0.0F, 4);
  EXPECT_EQ(one.mean(), many.mean());
  EXPECT_EQ(one.deviation(), many.deviation());
  EXPECT_EQ(one.edges(), many.edges());
}

TEST(Distribution, OfOneValueIsThatValue) {
  for (const float value : {0.0F, -3.25F, 45.0F, 1e9F}) {
    const Distribution all = tallied(std::vector<float>(1000, value), 0.0F);
    for (const double share : {0.0, 0.05, 0.5, 1.0}) EXPECT_EQ(all.quantile(share), static_cast<double>(value));
    EXPECT_EQ(all.mean(), static_cast<double>(value));
    EXPECT_EQ(all.deviation(), 0.0);
  }
}

TEST(Distribution, OfWholeNumbersIsOfThose) {
  const Distribution all = tallied({1, 1, 1, 2, 2, 3, 400, 511, 100'000}, 0.0F, 1, true);
  EXPECT_EQ(all.quantile(0.3), 1.0);
  EXPECT_EQ(all.quantile(0.5), 2.0);
  EXPECT_EQ(all.quantile(0.85), 511.0);
  EXPECT_EQ(all.quantile(1.0), 100'000.0);
  EXPECT_NEAR(all.up_to(1.0), 1.0 / 3.0, 1e-12);
  EXPECT_EQ(all.below(1.0), 0.0);
}

TEST(Distribution, OfNothingIsNotANumber) {
  const Distribution none, some({1.0, 2.0});
  EXPECT_TRUE(none.empty());
  for (const double value : {none.mean(), none.deviation(), none.quantile(0.5), none.low(), none.up_to(3.0),
                             wasserstein(none, some), wasserstein(some, none)})
    EXPECT_TRUE(std::isnan(value));
  EXPECT_TRUE(tallied({}, 0.0F).empty());
  EXPECT_TRUE(none.logarithmic(1.0).empty());
}

TEST(Distribution, LogarithmicIsOfTheScaledValues) {
  const Distribution all = tallied({1, 10, 100, 1000}, 0.0F).logarithmic(100.0);
  EXPECT_NEAR(all.low(), 2.0, 1e-12);
  EXPECT_NEAR(all.high(), 5.0, 1e-12);
  EXPECT_NEAR(all.mean(), 3.5, 2e-3);
  EXPECT_NEAR(all.deviation(), std::sqrt(1.25), 2e-3);
}

TEST(Distribution, WassersteinIsTheDistanceMoved) {
  const Distribution a({1.0, 2.0, 4.0}), b({3.0, 4.0, 6.0}), one({2.0});
  EXPECT_NEAR(wasserstein(a, b), 2.0, 1e-12);
  EXPECT_NEAR(wasserstein(b, a), 2.0, 1e-12);
  EXPECT_NEAR(wasserstein(a, one), 1.0, 1e-12);
  EXPECT_EQ(wasserstein(a, a), 0.0);
  // Sorted values of two sets of one size differ by it on average, whatever the bins.
  const std::vector<float> first = heavy_tailed(20'000, 1, 5.0F, 1.0F), second = heavy_tailed(20'000, 2, 9.0F, 4.0F);
  std::vector<double> left(first.begin(), first.end()), right(second.begin(), second.end());
  std::sort(left.begin(), left.end());
  std::sort(right.begin(), right.end());
  double mean = 0.0;
  for (size_t i = 0; i < left.size(); ++i) mean += std::abs(left[i] - right[i]) / static_cast<double>(left.size());
  EXPECT_NEAR(wasserstein(Distribution(left), Distribution(right)), mean, 1e-9);
  EXPECT_NEAR(wasserstein(tallied(first, 0.0F), tallied(second, -2.0F)), mean, 2e-3 * mean);
}

TEST(Bearings, MeanAndDistanceGoRoundTheCircle) {
  Bearings north, also_north, none;
  north.add(357.5F);
  also_north.add(2.5F);
  EXPECT_NEAR(circular_wasserstein(north, also_north), 5.0, 1e-9);
  EXPECT_EQ(circular_wasserstein(north, north), 0.0);
  EXPECT_TRUE(std::isnan(circular_wasserstein(north, none)));
  north += also_north;
  EXPECT_NEAR(std::remainder(north.mean_deg(), 360.0), 0.0, 1e-4);
  EXPECT_NEAR(north.strength(), std::cos(2.5 * 3.14159265 / 180.0), 1e-6);
  EXPECT_TRUE(std::isnan(none.mean_deg()));
  EXPECT_TRUE(std::isnan(none.strength()));
}

}  // namespace
}  // namespace seamount::hydrology
