#include "seamount/geom/polygon/poisson_disc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace seamount::geom {
namespace {

constexpr int32_t kSpacing = DiscSampling::kSpacing;

Ring rectangle(double west, double south, double east, double north) {
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}

Ring circle(Vec2 centre, double radius) {
  Ring ring;
  for (int i = 0; i < 60; ++i) {
    const double angle = std::numbers::pi * i / 30;
    ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return ring;
}

/// Squared distance in lattice units from a place to the nearest sample, by buckets.
class Nearest {
 public:
  explicit Nearest(const DiscSampling& sampling) {
    for (const LatticePoint p : sampling.points) buckets_[{p.x / kSpacing, p.y / kSpacing}].push_back(p);
  }

  int64_t operator()(LatticePoint place, bool skip_itself = false) const {
    int64_t best = std::numeric_limits<int64_t>::max();
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const auto bucket = buckets_.find({place.x / kSpacing + dx, place.y / kSpacing + dy});
        if (bucket == buckets_.end()) continue;
        for (const LatticePoint p : bucket->second) {
          if (!skip_itself || p != place) best = std::min(best, squared_distance(p, place));
        }
      }
    }
    return best;
  }

 private:
  std::map<std::pair<int, int>, std::vector<LatticePoint>> buckets_;
};

constexpr int64_t kSquared = int64_t{kSpacing} * kSpacing;

TEST(PoissonDiscs, KeepTheirDistanceAndLeaveNoHole) {
  const Box box{{-100, 50}, {900, 1050}};
  const DiscSampling sampling = poisson_discs({{rectangle(-1e4, -1e4, 1e4, 1e4), {}}}, 0, box, 10, Seed{1}, {});
  const Nearest nearest(sampling);
  for (const LatticePoint p : sampling.points) ASSERT_GE(nearest(p, true), kSquared);
  Rng rng(Seed{2});
  const int end = static_cast<int>(1000 / sampling.lattice.unit_m);
  for (int i = 0; i < 200000; ++i) ASSERT_LT(nearest({rng.integer(0, end), rng.integer(0, end)}), kSquared) << i;
  for (int32_t i = 0; i < end; i += 7) {  // along the southern edge
    ASSERT_LT(nearest({i, 0}), kSquared);
  }
  const double expected = kDiscDensity * 1000 * 1000 / (10.0 * 10.0);
  EXPECT_NEAR(static_cast<double>(sampling.points.size()), expected, 0.03 * expected);
}

TEST(PoissonDiscs, CoverAreasAndTheirMarginAlone) {
  const std::vector<Polygon> areas = {{circle({300, 300}, 150), {circle({300, 300}, 60)}},
                                      {circle({3000, 700}, 9), {}}};
  const DiscSampling sampling = poisson_discs(areas, 20, {{0, 0}, {4000, 1000}}, 10, Seed{3}, {});
  const Nearest nearest(sampling);
  for (const LatticePoint p : sampling.points) {
    const Vec2 place = sampling.lattice.place(p);
    const double ring = std::hypot(place.x - 300, place.y - 300);
    const double dot = std::hypot(place.x - 3000, place.y - 700);
    ASSERT_TRUE((ring > 0 && ring < 150 + 60) || dot < 9 + 60) << place.x << " " << place.y;
  }
  Rng rng(Seed{4});
  for (int i = 0; i < 50000; ++i) {
    const double angle = rng.uniform(0, 2 * std::numbers::pi), radius = rng.uniform(45, 165);
    const Vec2 place = {300 + radius * std::cos(angle), 300 + radius * std::sin(angle)};
    const double unit = sampling.lattice.unit_m;
    const LatticePoint p = {static_cast<int32_t>(place.x / unit), static_cast<int32_t>(place.y / unit)};
    ASSERT_LT(nearest(p), kSquared);
  }
}

TEST(PoissonDiscs, AreasBelowOneCellAndLongEdgesAreNotMissed) {
  const Ring sliver = {{10, 10}, {9000, 401}, {9000, 402}};
  const DiscSampling sampling = poisson_discs({{sliver, {}}}, 0, {{0, 0}, {10000, 1000}}, 50, Seed{5}, {});
  const Nearest nearest(sampling);
  for (double x = 10; x < 9000; x += 3) {
    const double y = 10 + 391.5 * (x - 10) / 8990;
    const double unit = sampling.lattice.unit_m;
    ASSERT_LT(nearest({static_cast<int32_t>(x / unit), static_cast<int32_t>(y / unit)}), kSquared) << x;
  }
  EXPECT_LT(sampling.points.size(), 1200U);
  EXPECT_GE(poisson_discs({{circle({5, 5}, 0.01), {}}}, 0, {{0, 0}, {10, 10}}, 3, Seed{1}, {}).points.size(), 1U);
  EXPECT_TRUE(poisson_discs({}, 5, {{0, 0}, {10, 10}}, 3, Seed{1}, {}).points.empty());
}

TEST(PoissonDiscs, AreTheSameOnAnyNumberOfThreads) {
  const std::vector<Polygon> areas = {{circle({500, 500}, 480), {}}};
  const Box box{{0, 0}, {1000, 1000}};
  RunContext one;
  one.threads = 1;
  RunContext four;
  four.threads = 4;
  const DiscSampling a = poisson_discs(areas, 10, box, 4, Seed{6}, one);
  EXPECT_EQ(a.points, poisson_discs(areas, 10, box, 4, Seed{6}, four).points);
  EXPECT_NE(a.points, poisson_discs(areas, 10, box, 4, Seed{7}, four).points);
}

/// Tiles are filled one after another: where they meet must not show as a line of more or fewer points.
TEST(PoissonDiscs, TilesDoNotShow) {
  const DiscSampling sampling =
      poisson_discs({{rectangle(-1, -1, 3001, 3001), {}}}, 0, {{0, 0}, {3000, 3000}}, 4, Seed{8}, {});
  constexpr int32_t kTile = 32 * 4096;
  constexpr size_t kBands = 32;
  std::vector<double> count(kBands, 0.0);
  const int32_t whole = static_cast<int32_t>(3000 / sampling.lattice.unit_m) / kTile * kTile;
  for (const LatticePoint p : sampling.points) {
    if (p.x < whole) count[static_cast<size_t>(p.x % kTile / 4096)] += 1.0;
  }
  double mean = 0.0;
  for (const double c : count) mean += c / kBands;
  for (const double c : count) EXPECT_NEAR(c / mean, 1.0, 0.03);
}

TEST(PoissonDiscs, AreCancelled) {
  const std::atomic<bool> stop = true;
  RunContext run;
  run.cancelled = &stop;
  EXPECT_THROW(poisson_discs({{rectangle(0, 0, 1000, 1000), {}}}, 0, {{0, 0}, {1000, 1000}}, 1, Seed{1}, run),
               Cancelled);
}

}  // namespace
}  // namespace seamount::geom
