#include "seamount/ops/contour/growth/growth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "seamount/geom/scalar/weighted_sampler.h"

namespace seamount::contour {
namespace {

size_t at(int32_t i) { return static_cast<size_t>(i); }

/// A graph of one region from undirected edges.
RegionGraph graph_of(int nodes, const std::vector<std::pair<int32_t, int32_t>>& edges) {
  std::vector<std::vector<int32_t>> around(static_cast<size_t>(nodes));
  for (const auto& [a, b] : edges) {
    around[at(a)].push_back(b);
    around[at(b)].push_back(a);
  }
  RegionGraph graph;
  graph.starts = {0};
  for (const std::vector<int32_t>& list : around) {
    graph.neighbours.insert(graph.neighbours.end(), list.begin(), list.end());
    graph.starts.push_back(static_cast<uint32_t>(graph.neighbours.size()));
  }
  return graph;
}

double chi_squared(const std::vector<int>& counts, const std::vector<double>& shares) {
  double draws = 0.0, sum = 0.0;
  for (const int count : counts) draws += count;
  for (size_t i = 0; i < counts.size(); ++i) {
    const double expected = draws * shares[i];
    sum += (counts[i] - expected) * (counts[i] - expected) / expected;
  }
  return sum;
}

/// Eight seeds with a leaf each: the first leaf to be reached tells which seed was drawn first.
std::vector<int> first_draws(const std::vector<double>& p, bool against) {
  std::vector<std::pair<int32_t, int32_t>> edges;
  std::vector<int32_t> seeds;
  std::vector<uint32_t> weights;
  for (int32_t i = 0; i < 8; ++i) {
    edges.emplace_back(i, i + 8);
    seeds.push_back(i);
    weights.push_back(growth_weight(p[at(i)]));
  }
  weights.resize(16, growth_weight(0.5));
  const RegionGraph graph = graph_of(16, edges);
  std::vector<int> counts(8, 0);
  for (uint64_t seed = 0; seed < 20000; ++seed) {
    std::vector<uint32_t> step(16, 0);
    eden_growth(graph, seeds, weights, against, Rng(Seed{seed}.derive("test")), step, {});
    const auto first = std::find(step.begin() + 8, step.end(), 9U);
    ++counts[static_cast<size_t>(first - step.begin() - 8)];
  }
  return counts;
}

TEST(EdenGrowth, DrawsInProportionToTheProbability) {
  const std::vector<double> p = {0.0, 0.004, 0.05, 0.2, 0.25, 0.5, 0.77, 1.0};
  std::vector<double> shares, against;
  double sum = 0.0, sum_against = 0.0;
  for (const double value : p) {
    shares.push_back(std::clamp(value, 0.001, 0.999));
    against.push_back(1.0 - shares.back());
    sum += shares.back();
    sum_against += against.back();
  }
  for (double& share : shares) share /= sum;
  for (double& share : against) share /= sum_against;
  EXPECT_LT(chi_squared(first_draws(p, false), shares), 18.5);  // 7 degrees of freedom: 1 % of true samples are above
  EXPECT_LT(chi_squared(first_draws(p, true), against), 18.5);
}

TEST(EdenGrowth, TakesFreeNeighboursAllAlike) {
  const RegionGraph graph = graph_of(6, {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}});
  const std::vector<uint32_t> weights = {10, 1, 1000, 30000, 7, 1U << 29};
  std::vector<int> counts(5, 0);
  for (uint64_t seed = 0; seed < 10000; ++seed) {
    std::vector<uint32_t> step(6, 0);
    eden_growth(graph, std::vector<int32_t>{0}, weights, false, Rng(Seed{seed}.derive("test")), step, {});
    ++counts[static_cast<size_t>(std::find(step.begin(), step.end(), 2U) - step.begin() - 1)];
    std::vector<uint32_t> sorted = step;
    std::sort(sorted.begin(), sorted.end());
    ASSERT_EQ(sorted, (std::vector<uint32_t>{1, 2, 3, 4, 5, 6}));
  }
  EXPECT_LT(chi_squared(counts, std::vector<double>(5, 0.2)), 13.3);  // 4 degrees of freedom
}

TEST(EdenGrowth, EntersOnlyFreeNodes) {
  const RegionGraph graph = graph_of(6, {{0, 1}, {1, 2}, {2, 3}, {4, 5}});
  const std::vector<uint32_t> weights(6, 5);
  std::vector<uint32_t> step = {0, 0, 99, 0, 0, 0};
  eden_growth(graph, std::vector<int32_t>{0, 4, 0}, weights, false, Rng(Seed{1}), step, {});
  EXPECT_EQ(step[0], 1U);
  EXPECT_EQ(step[4], 2U);
  EXPECT_EQ(step[1] + step[5], 7U);
  EXPECT_EQ(step[2], 99U);
  EXPECT_EQ(step[3], 0U);
}

TEST(GrowthWeight, IsClamped) {
  EXPECT_EQ(growth_weight(0.0), growth_weight(0.001));
  EXPECT_EQ(growth_weight(1.0), growth_weight(0.999));
  EXPECT_LT(growth_weight(1.0), geom::WeightedSampler::kMost);
  EXPECT_EQ(growth_weight(0.5), geom::WeightedSampler::kMost / 2);
}

std::vector<TinRegion> nested(const std::vector<std::pair<int, bool>>& parents_and_basins) {
  std::vector<TinRegion> regions;
  for (const auto& [parent, basin] : parents_and_basins) regions.push_back({"", parent, {}, {}, basin});
  return regions;
}

TEST(BorderOf, KnowsWhatDrainsWhere) {
  // 0 land; 1 hill in it; 2 crater in the hill; 3 another hill; 4 peak on 1; 5 island in the crater; 6 another land
  const auto regions = nested({{-1, false}, {0, false}, {1, true}, {0, false}, {1, false}, {2, false}, {-1, false}});
  const auto side = [&](int here, int there) { return border_of(regions, here, there).side; };
  EXPECT_EQ(side(0, -1), Side::lower);
  EXPECT_EQ(side(0, 1), Side::upper);
  EXPECT_EQ(side(0, 6), Side::across);
  EXPECT_EQ(side(1, 0), Side::lower);
  EXPECT_EQ(side(1, -1), Side::lower);  // the land between is thinner than the spacing
  EXPECT_EQ(side(1, 2), Side::lower);
  EXPECT_EQ(side(1, 4), Side::upper);
  EXPECT_EQ(side(1, 3), Side::across);
  EXPECT_EQ(side(1, 5), Side::lower);
  EXPECT_EQ(side(2, 1), Side::upper);
  EXPECT_EQ(side(2, 5), Side::upper);
  EXPECT_EQ(side(5, 2), Side::lower);
  EXPECT_EQ(border_of(regions, 0, 5).beyond, 1);
  EXPECT_EQ(border_of(regions, 1, 0).beyond, -1);
}

/// A strip of 2 x width squares, each of two triangles; node (x, y) is 3 x + y.
std::vector<std::array<int32_t, 3>> strip(int32_t width) {
  std::vector<std::array<int32_t, 3>> triangles;
  for (int32_t x = 0; x + 1 < width; ++x) {
    for (int32_t y = 0; y < 2; ++y) {
      const int32_t a = 3 * x + y;
      triangles.push_back({a, a + 3, a + 4});
      triangles.push_back({a, a + 4, a + 1});
    }
  }
  return triangles;
}

TEST(RegionGraph, NeighboursAreMutualAtTheRimToo) {
  const auto triangles = strip(20);
  std::vector<int32_t> region(60);
  for (int32_t i = 0; i < 60; ++i) region[at(i)] = i < 12 ? -1 : (i < 36 ? 0 : 1);
  const RegionGraph graph = make_region_graph(triangles, region, nested({{-1, false}, {0, false}}), {});
  std::set<std::pair<int32_t, int32_t>> expected, found;
  for (const auto& t : triangles) {
    for (size_t k = 0; k < 3; ++k) {
      const int32_t a = t[k], b = t[(k + 1) % 3];
      if (region[at(a)] < 0 || region[at(a)] != region[at(b)]) continue;
      expected.insert({a, b});
      expected.insert({b, a});
    }
  }
  for (int32_t i = 0; i < 60; ++i) {
    for (const int32_t n : graph.around(i)) EXPECT_TRUE(found.insert({i, n}).second);
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(graph.members(0).size(), 24U);
  EXPECT_EQ(graph.members(1).front(), 36);
  ASSERT_EQ(graph.borders[0].size(), 6U);
  EXPECT_EQ(graph.borders[0][0], (BorderNode{12, -1, Side::lower}));
  EXPECT_EQ(graph.borders[0][5], (BorderNode{35, 1, Side::upper}));
  EXPECT_EQ(graph.rim.size(), 2U * 8 * 2 + 1);
}

/// On a long strip from the sea to a hill, n- / (n- + n+) rises steadily from one border to the other.
TEST(GrowRanks, TwoFrontsMeetInOrder) {
  const int32_t width = 60;
  std::vector<int32_t> region(static_cast<size_t>(3 * width), 0);
  for (size_t i = 0; i < 3; ++i) region[i] = -1;
  for (size_t i = region.size() - 6; i < region.size(); ++i) region[i] = 1;
  const std::vector<float> half(region.size(), 0.5F);
  const auto ranks = grow_ranks(strip(width), region, nested({{-1, false}, {0, false}}), half, {}, Seed{1}, {});
  for (int32_t x = 1; x + 12 < width; ++x) EXPECT_LT(ranks[at(3 * x + 1)], ranks[at(3 * (x + 10) + 1)]);
  EXPECT_EQ(ranks[0], 0.0F);
  EXPECT_LT(ranks[4], 0.05F);
  EXPECT_GT(ranks[at(3 * (width - 3) + 1)], 0.95F);
}

TEST(GrowRanks, ABasinFallsInwards) {
  const int32_t width = 40;
  std::vector<int32_t> region(static_cast<size_t>(3 * width), 1);
  for (size_t i = 0; i < 12; ++i) region[i] = i < 3 ? -1 : 0;
  const std::vector<float> half(region.size(), 0.5F);
  const auto ranks = grow_ranks(strip(width), region, nested({{-1, false}, {0, true}}), half, {}, Seed{1}, {});
  EXPECT_GT(ranks[at(3 * 4 + 1)], 0.9F);
  EXPECT_LT(ranks[at(3 * (width - 1) + 1)], 0.1F);
}

TEST(GrowRanks, LandWithoutCoastStartsAtTheRim) {
  const std::vector<int32_t> region(60, 0);
  const std::vector<float> half(60, 0.5F);
  const auto ranks = grow_ranks(strip(20), region, nested({{-1, false}}), half, {}, Seed{1}, {});
  for (int32_t x = 1; x < 19; ++x) EXPECT_GT(ranks[at(3 * x + 1)], 42.0F / 60.0F);  // 42 of the nodes are the rim
  EXPECT_TRUE(grow_ranks({}, {}, nested({{-1, false}}), {}, {}, Seed{1}, {}).empty());
}

/// A low hill beside a high one: the ground around the low one stays near the low one's level.
TEST(GrowRanks, KnownHeightsSayWhereFrontsStart) {
  const int32_t width = 120;
  std::vector<int32_t> region(static_cast<size_t>(3 * width), 0);
  for (size_t i = 0; i < 3; ++i) {
    region[i] = -1;
    region[i + region.size() - 3] = 2;
  }
  region[151] = 1;
  auto regions = nested({{-1, false}, {0, false}, {0, false}});
  const std::vector<float> half(region.size(), 0.5F);
  const auto plain = grow_ranks(strip(width), region, regions, half, {}, Seed{1}, {});
  regions[0].height_m = 0.0;
  regions[1].height_m = 100.0;
  regions[2].height_m = 1000.0;
  const auto known = grow_ranks(strip(width), region, regions, half, {}, Seed{1}, {});
  EXPECT_NE(plain, known);
  EXPECT_LT(known[at(3 * 49 + 1)], 0.45F);
}

}  // namespace
}  // namespace seamount::contour
