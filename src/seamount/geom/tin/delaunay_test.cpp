#include "seamount/geom/tin/delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

std::vector<LatticePoint> random_points(uint64_t seed, int count, int32_t extent) {
  Rng rng(Seed{seed});
  std::vector<LatticePoint> points;
  for (int i = 0; i < count; ++i) points.push_back({rng.integer(0, extent - 1), rng.integer(0, extent - 1)});
  return points;
}

/// Twice the area of the convex hull (Andrew's monotone chain).
int64_t hull_area(std::vector<LatticePoint> points) {
  std::sort(points.begin(), points.end());
  std::vector<LatticePoint> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const size_t start = hull.size();
    for (const LatticePoint p : points) {
      while (hull.size() >= start + 2 && orientation(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  int64_t area = 0;
  for (size_t i = 2; i < hull.size(); ++i) area += orientation(hull[0], hull[i - 1], hull[i]);
  return area;
}

/// Everything that makes a set of triangles a Delaunay triangulation of these points, by brute force.
void expect_delaunay(const std::vector<LatticePoint>& points, const std::vector<Triangle>& triangles) {
  const auto at = [&](int32_t i) { return points[static_cast<size_t>(i)]; };
  std::map<std::pair<int32_t, int32_t>, int> edges;
  std::set<LatticePoint> used;
  int64_t area = 0;
  for (const Triangle& t : triangles) {
    const int64_t twice = orientation(at(t[0]), at(t[1]), at(t[2]));
    ASSERT_GT(twice, 0);
    ASSERT_LT(t[0], std::min(t[1], t[2]));
    area += twice;
    for (size_t k = 0; k < 3; ++k) {
      ASSERT_EQ(++edges[std::pair(t[k], t[(k + 1) % 3])], 1);
      used.insert(at(t[k]));
    }
    for (const LatticePoint p : points) ASSERT_FALSE(in_circle(at(t[0]), at(t[1]), at(t[2]), p));
  }
  EXPECT_TRUE(std::is_sorted(triangles.begin(), triangles.end(),
                             [](const Triangle& a, const Triangle& b) { return a[0] < b[0]; }));
  EXPECT_EQ(area, hull_area(points));
  EXPECT_EQ(used, std::set<LatticePoint>(points.begin(), points.end()));
}

TEST(InCircle, AgreesWithACircleOfKnownCentre) {
  const LatticePoint a{10, 5}, b{5, 10}, c{0, 5};  // centre (5, 5), radius 5
  EXPECT_TRUE(in_circle(a, b, c, {5, 1}));
  EXPECT_FALSE(in_circle(a, b, c, {5, 0}));
  EXPECT_FALSE(in_circle(a, b, c, {9, 1}));
  const int32_t end = kLatticeEnd - 1;  // the largest numbers: one unit decides
  EXPECT_FALSE(in_circle({0, 0}, {end, 0}, {end, end}, {0, end}));
  EXPECT_TRUE(in_circle({0, 0}, {end, 0}, {end, end}, {1, end}));
  EXPECT_FALSE(in_circle({0, 1}, {end, 0}, {end, end}, {0, end}));
}

TEST(Delaunay, RandomPointsAgreeWithBruteForce) {
  for (uint64_t seed = 0; seed < 60; ++seed) {
    const int count = 3 + static_cast<int>(seed * 3);
    const std::vector<LatticePoint> points = random_points(seed, count, kLatticeEnd);
    expect_delaunay(points, delaunay(points, {}));
  }
}

TEST(Delaunay, CoarsePointsWithCirclesLinesAndTwins) {
  for (uint64_t seed = 0; seed < 100; ++seed) {
    const std::vector<LatticePoint> points = random_points(seed, 40, 4 + static_cast<int32_t>(seed % 9));
    expect_delaunay(points, delaunay(points, {}));
  }
}

TEST(Delaunay, GridsAndRectangles) {
  for (const auto& [width, height] : {std::pair(12, 12), std::pair(2, 40), std::pair(40, 2), std::pair(3, 3)}) {
    std::vector<LatticePoint> points;
    for (int32_t y = 0; y < height; ++y) {
      for (int32_t x = 0; x < width; ++x) points.push_back({7 * x, 7 * y});
    }
    const std::vector<Triangle> triangles = delaunay(points, {});
    EXPECT_EQ(triangles.size(), static_cast<size_t>(2 * (width - 1) * (height - 1)));
    expect_delaunay(points, triangles);
  }
}

TEST(Delaunay, TooFewOrOnALine) {
  using Points = std::vector<LatticePoint>;
  EXPECT_TRUE(delaunay(Points{}, {}).empty());
  EXPECT_TRUE(delaunay(Points{{1, 1}}, {}).empty());
  EXPECT_TRUE(delaunay(Points{{1, 1}, {2, 1}}, {}).empty());
  EXPECT_TRUE(delaunay(Points{{1, 1}, {1, 1}, {1, 1}, {1, 1}}, {}).empty());
  EXPECT_TRUE(delaunay(Points{{0, 0}, {3, 6}, {1, 2}, {2, 4}, {0, 0}}, {}).empty());
  EXPECT_EQ(delaunay(Points{{5, 0}, {0, 0}, {0, 5}}, {}), (std::vector<Triangle>{{0, 2, 1}}));
  EXPECT_EQ(delaunay(Points{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {2, 9}}, {}).size(), 3U);
}

TEST(Delaunay, LongThinSets) {
  std::vector<LatticePoint> points;
  for (int32_t i = 0; i < 300; ++i) points.push_back({i * 1000000, (i * i) % 7});
  for (int32_t i = 0; i < 200; ++i) points.push_back({5, i * 2000000 + 11});
  expect_delaunay(points, delaunay(points, {}));
}

TEST(Delaunay, PlacesInMetres) {
  const std::vector<Vec2> points = {{-500.5, 1e6}, {500.5, 1e6}, {0.0, 1e6 + 300.25}, {0.0, 1e6 + 10}};
  EXPECT_EQ(delaunay(points, {}).size(), 3U);
  EXPECT_TRUE(delaunay(std::vector<Vec2>{}, {}).empty());
}

TEST(Delaunay, TenThousandPointsHaveLocallyEmptyCircles) {
  std::vector<LatticePoint> points = random_points(3, 10000, kLatticeEnd);
  std::sort(points.begin(), points.end());  // not in spatial order
  const std::vector<Triangle> triangles = delaunay(points, {});
  std::map<std::pair<int32_t, int32_t>, int32_t> apex;
  for (const Triangle& t : triangles) {
    for (size_t k = 0; k < 3; ++k) apex[std::pair(t[k], t[(k + 1) % 3])] = t[(k + 2) % 3];
  }
  const auto at = [&](int32_t i) { return points[static_cast<size_t>(i)]; };
  size_t hull = 0;
  for (const auto& [edge, corner] : apex) {
    const auto other = apex.find({edge.second, edge.first});
    if (other == apex.end()) {
      ++hull;
    } else {
      ASSERT_FALSE(in_circle(at(edge.first), at(edge.second), at(corner), at(other->second)));
    }
  }
  EXPECT_EQ(triangles.size(), 2 * points.size() - 2 - hull);
}

TEST(Delaunay, IsCancelled) {
  const std::atomic<bool> stop = true;
  RunContext run;
  run.cancelled = &stop;
  EXPECT_THROW(delaunay(random_points(1, 100000, kLatticeEnd), run), Cancelled);
}

TEST(SpatialOrder, IsAPermutationOfShortSteps) {
  std::vector<LatticePoint> points;
  for (int32_t i = 0; i < 4096; ++i) points.push_back({(i * 37 % 64) * 100, (i / 64) * 100});
  const std::vector<int32_t> order = spatial_order(points);
  std::vector<int32_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (size_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], static_cast<int32_t>(i));
  double length = 0.0;
  for (size_t i = 1; i < order.size(); ++i) {
    length += std::sqrt(static_cast<double>(
        squared_distance(points[static_cast<size_t>(order[i - 1])], points[static_cast<size_t>(order[i])])));
  }
  EXPECT_LT(length, 1.2 * 100 * 4095);  // a curve of unit steps has 4095
}

TEST(DelaunayBuilder, AnswersWhatChangedInEitherPrecision) {
  Rng rng(Seed{11}.derive("points"));
  std::vector<LatticePoint> points;
  for (int i = 0; i < 400; ++i)
    points.push_back({static_cast<int32_t>(rng.uniform(0, 60)), static_cast<int32_t>(rng.uniform(0, 16383))});
  DelaunayBuilder<14> narrow(points);
  DelaunayBuilder<kLatticeBits> wide(points);
  const std::vector<int32_t> order = spatial_order(points);
  ASSERT_TRUE(narrow.start(order));
  ASSERT_TRUE(wide.start(order));
  for (const int32_t p : order) {
    const std::span<const int32_t> changed = narrow.insert(p), other = wide.insert(p);
    EXPECT_EQ(std::vector(changed.begin(), changed.end()), std::vector(other.begin(), other.end()));
    for (const int32_t t : changed) {
      const Triangle corners = narrow.corners(t);
      EXPECT_EQ(corners, wide.corners(t));
      EXPECT_EQ(std::count(corners.begin(), corners.end(), p), 1);
    }
  }
  EXPECT_TRUE(narrow.insert(order[7]).empty()) << "there already";
}

}  // namespace
}  // namespace seamount::geom
