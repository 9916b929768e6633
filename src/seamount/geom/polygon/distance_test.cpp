#include "seamount/geom/polygon/distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seamount/base/rng.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::geom {
namespace {

Grid<uint8_t> random_set(int width, int height, double share, uint64_t seed) {
  Grid<uint8_t> set({width, height, 2.5, 10, 20, {}}, uint8_t{0});
  Rng rng(Seed{seed});
  for (uint8_t& cell : set.cells()) cell = rng.chance(share) ? 1 : 0;
  return set;
}

int64_t squared_to_nearest(const Grid<uint8_t>& set, int x, int y) {
  int64_t best = std::numeric_limits<int64_t>::max();
  for (int v = 0; v < set.height(); ++v) {
    for (int u = 0; u < set.width(); ++u) {
      if (set(u, v) != 0) best = std::min<int64_t>(best, (u - x) * (u - x) + (v - y) * (v - y));
    }
  }
  return best;
}

TEST(DistanceTo, AgreesWithBruteForceOnOddShapes) {
  uint64_t seed = 0;
  for (const auto& [width, height] : {std::pair(1, 1), {1, 40}, {40, 1}, {2, 3}, {37, 23}, {16, 64}}) {
    for (const double share : {0.01, 0.1, 0.6}) {
      Grid<uint8_t> set = random_set(width, height, share, ++seed);
      set(width / 3, height / 2) = 1;
      const ScalarField distance = distance_to(set, {});
      Grid<int32_t> nearest;
      ScalarField also;
      nearest_feature(set, nearest, also, {});
      ASSERT_EQ(also, distance);
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const int64_t squared = squared_to_nearest(set, x, y);
          ASSERT_FLOAT_EQ(distance(x, y), 2.5F * std::sqrt(static_cast<float>(squared)));
          const int u = nearest(x, y) % width, v = nearest(x, y) / width;
          ASSERT_NE(set(u, v), 0);
          ASSERT_EQ((u - x) * (u - x) + (v - y) * (v - y), squared);
        }
      }
    }
  }
}

TEST(DistanceTo, EmptySetIsInfinitelyFar) {
  const Grid<uint8_t> none({7, 5, 1, 0, 0, {}}, uint8_t{0});
  const ScalarField distance = distance_to(none, {});
  for (const float d : distance.cells()) EXPECT_EQ(d, std::numeric_limits<float>::infinity());
  Grid<int32_t> nearest;
  nearest_feature(none, nearest, {});
  for (const int32_t i : nearest.cells()) EXPECT_EQ(i, -1);
}

TEST(DistanceTo, IsTheSameOnAnyNumberOfThreads) {
  const Grid<uint8_t> set = random_set(517, 401, 0.001, 5);
  RunContext one, four;
  one.threads = 1;
  four.threads = 4;
  EXPECT_EQ(distance_to(set, one), distance_to(set, four));
  const Polygon triangle = {{{20, 0}, {900, -30}, {400, -800}}, {}};
  EXPECT_EQ(signed_distance({triangle}, set.frame(), one), signed_distance({triangle}, set.frame(), four));
}

Ring star(Vec2 centre, double radius, int points, uint64_t seed) {
  Rng rng(Seed{seed});
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points, r = radius * rng.uniform(0.5, 1.0);
    ring.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
  }
  return ring;
}

double to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double t = dot(d, d) > 0 ? std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0) : 0.0;
  const Vec2 off = p - (a + t * d);
  return std::hypot(off.x, off.y);
}

double to_rings(Vec2 p, const Polygon& polygon) {
  double best = std::numeric_limits<double>::infinity();
  const auto visit = [&](const Ring& ring) {
    for (size_t i = 0; i < ring.size(); ++i) best = std::min(best, to_segment(p, ring[i], ring[(i + 1) % ring.size()]));
  };
  visit(polygon.outer);
  for (const Ring& hole : polygon.holes) visit(hole);
  return best;
}

TEST(SignedDistance, AgreesWithBruteForce) {
  uint64_t seed = 0;
  for (const auto& [width, height] : {std::pair(1, 1), {130, 97}, {5, 300}, {64, 64}}) {
    for (const int points : {3, 20, 400}) {
      const GridFrame frame = {width, height, 4.0, -0.5 * width * 4, 0.5 * height * 4, {}};
      const double radius = 1.8 * std::min(width, height);
      const Polygon island = {star({3, 5}, radius, points, ++seed), {star({3, 5}, 0.3 * radius, points, ++seed)}};
      const ScalarField field = signed_distance({island}, frame, {});
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const Vec2 p = {frame.x(x), frame.y(y)};
          const double expected = to_rings(p, island) * (contains(island, p) ? -1 : 1);
          ASSERT_NEAR(field(x, y), expected, 1e-3 + 1e-6 * std::abs(expected)) << x << ' ' << y;
        }
      }
    }
  }
}

TEST(SignedDistance, OfTwoIslandsAndOfNone) {
  const GridFrame frame = GridFrame::centred(100, 40, 1.0);
  const Polygon left = {star({-25, 0}, 12, 30, 1), {}}, right = {star({20, 3}, 9, 17, 2), {}};
  const ScalarField both = signed_distance({left, right}, frame, {});
  const ScalarField a = signed_distance({left}, frame, {}), b = signed_distance({right}, frame, {});
  for (size_t i = 0; i < both.size(); ++i) EXPECT_EQ(both.cells()[i], std::min(a.cells()[i], b.cells()[i]));
  const ScalarField none = signed_distance({}, frame, {});
  EXPECT_EQ(none(3, 3), std::numeric_limits<float>::infinity());
}

TEST(DistanceToLines, MeasuresToSegmentsAndPoints) {
  const GridFrame frame = GridFrame::centred(60, 60, 1.0);
  const ScalarField field = distance_to_lines({{{-10, 0}, {10, 0}, {10, 20}}, {{-20, -20}}, {}}, frame, {});
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) {
      const Vec2 p = {frame.x(x), frame.y(y)};
      const double expected = std::min(
          {to_segment(p, {-10, 0}, {10, 0}), to_segment(p, {10, 0}, {10, 20}), std::hypot(p.x + 20, p.y + 20)});
      EXPECT_NEAR(field(x, y), expected, 1e-5 * (1 + expected));
    }
  }
}

}  // namespace
}  // namespace seamount::geom
