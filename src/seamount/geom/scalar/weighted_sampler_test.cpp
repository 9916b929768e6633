#include "seamount/geom/scalar/weighted_sampler.h"

#include <gtest/gtest.h>

namespace seamount::geom {
namespace {

/// Pearson's statistic of counts against expectations in proportion to weights.
double chi_squared(const std::vector<int>& counts, const std::vector<uint32_t>& weights) {
  double weight = 0.0, draws = 0.0, sum = 0.0;
  for (size_t i = 0; i < counts.size(); ++i) {
    weight += weights[i];
    draws += counts[i];
  }
  for (size_t i = 0; i < counts.size(); ++i) {
    const double expected = draws * weights[i] / weight;
    sum += (counts[i] - expected) * (counts[i] - expected) / expected;
  }
  return sum;
}

TEST(WeightedSampler, DrawsInProportionToWeight) {
  // Two thousand small bags, so that not one stream of numbers is judged but many.
  const std::vector<uint32_t> weights = {1, 2, 3, 4, 5, 7, 8, 9, 31, 32, 33, 100, 127, 128, 129, 200};
  std::vector<int> counts(weights.size(), 0);
  for (uint64_t seed = 0; seed < 2000; ++seed) {
    WeightedSampler sampler;
    for (uint32_t i = 0; i < weights.size(); ++i) sampler.add(i, weights[i]);
    Rng rng(Seed{seed});
    for (int draw = 0; draw < 50; ++draw) ++counts[sampler.item(sampler.draw(rng))];
  }
  EXPECT_LT(chi_squared(counts, weights), 30.6);  // 15 degrees of freedom: 1 % of true samples are above
  EXPECT_GT(chi_squared(counts, weights), 5.2);   // and 1 % below
}

TEST(WeightedSampler, StaysInProportionWhenItemsComeAndGo) {
  Rng rng(Seed{7});
  std::vector<uint32_t> weights;
  WeightedSampler sampler;
  for (uint32_t i = 0; i < 64; ++i) {
    weights.push_back(static_cast<uint32_t>(rng.integer(1, 1000)) << (i % 3 * 9));
    sampler.add(i, weights.back());
  }
  std::vector<bool> gone(64, false);
  for (int i = 0; i < 32; ++i) {
    const WeightedSampler::Place place = sampler.draw(rng);
    gone[sampler.item(place)] = true;
    sampler.remove(place);
  }
  for (uint32_t i = 64; i < 80; ++i) {
    weights.push_back(WeightedSampler::kMost >> (i % 8));
    sampler.add(i, weights.back());
  }
  gone.resize(weights.size(), false);
  std::vector<int> counts(weights.size(), 0);
  for (int i = 0; i < 400000; ++i) ++counts[sampler.item(sampler.draw(rng))];
  std::vector<int> left;
  std::vector<uint32_t> left_weights;
  for (size_t i = 0; i < weights.size(); ++i) {
    if (gone[i]) {
      EXPECT_EQ(counts[i], 0);
    } else if (weights[i] > WeightedSampler::kMost / 65536) {
      left.push_back(counts[i]);
      left_weights.push_back(weights[i]);
    }
  }
  const double freedom = static_cast<double>(left.size()) - 1.0;
  EXPECT_LT(chi_squared(left, left_weights), freedom + 3.0 * std::sqrt(2.0 * freedom));
}

TEST(WeightedSampler, HoldsTheSmallestAndTheLargestWeights) {
  WeightedSampler sampler;
  EXPECT_TRUE(sampler.empty());
  sampler.add(5, 1);
  sampler.add(6, WeightedSampler::kMost);
  Rng rng(Seed{1});
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(sampler.item(sampler.draw(rng)), 6U);
  sampler.remove(sampler.draw(rng));
  EXPECT_EQ(sampler.item(sampler.draw(rng)), 5U);
  sampler.remove(sampler.draw(rng));
  EXPECT_TRUE(sampler.empty());
}

}  // namespace
}  // namespace seamount::geom
