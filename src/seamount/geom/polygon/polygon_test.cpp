#include "seamount/geom/polygon/polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

const Ring kSquare = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
const Ring kHole = {{2, 2}, {2, 4}, {4, 4}, {4, 2}};

Ring circle(Vec2 centre, double radius, int points) {
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return ring;
}

Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

TEST(Polygon, Measures) {
  EXPECT_EQ(signed_area(kSquare), 100);
  EXPECT_EQ(signed_area(reversed(kSquare)), -100);
  EXPECT_EQ(area({kSquare, {kHole}}), 96);
  EXPECT_EQ(perimeter({kSquare, {kHole}}), 48);
  EXPECT_EQ(line_length(kSquare), 30);
  EXPECT_NEAR(signed_area(circle({1e7, -1e7}, 100, 4000)), std::numbers::pi * 1e4, 0.1);
  const Box box = bounding_box(kHole);
  EXPECT_EQ(box.low, (Vec2{2, 2}));
  EXPECT_EQ(box.high, (Vec2{4, 4}));
  EXPECT_TRUE(bounding_box({}).empty());
  Polygon turned = {reversed(kSquare), {reversed(kHole)}};
  orient(turned);
  EXPECT_GT(signed_area(turned.outer), 0);
  EXPECT_LT(signed_area(turned.holes[0]), 0);
}

TEST(Polygon, ContainsIsFalseInHoles) {
  const Polygon polygon = {kSquare, {kHole}};
  EXPECT_TRUE(contains(polygon, {1, 1}));
  EXPECT_FALSE(contains(polygon, {3, 3}));
  EXPECT_FALSE(contains(polygon, {11, 3}));
  EXPECT_FALSE(contains(polygon, {-1, 10}));
}

std::string defect(const Polygon& polygon) { return find_defect(polygon).value_or("none"); }

TEST(FindDefect, SaysWhatAndWhere) {
  EXPECT_EQ(defect({kSquare, {kHole}}), "none");
  EXPECT_EQ(defect({{{0, 0}, {0, 0}, {10, 0}, {10, 10}, {10, 10}}, {}}), "none");
  EXPECT_THAT(defect({{{0, 0}, {1, 1}}, {}}), testing::HasSubstr("2 points"));
  EXPECT_THAT(defect({{{0, 0}, {1, 1}, {2, 2}}, {}}), testing::HasSubstr("no area"));
  EXPECT_THAT(defect({{{0, 0}, {0, 0}, {0, 0}, {0, 0}}, {}}), testing::HasSubstr("no area"));
  EXPECT_THAT(defect({{{0, 0}, {1, std::numeric_limits<double>::infinity()}, {2, 2}}, {}}),
              testing::HasSubstr("point 1"));
  EXPECT_EQ(defect({{{0, 0}, {10, 10}, {10, 0}, {0, 10}}, {}}),
            "edge 0 of the outer ring and edge 2 of the outer ring cross or touch at (5, 5)");
  EXPECT_THAT(defect({{{0, 0}, {10, 0}, {5, 0}, {5, 8}}, {}}), testing::HasSubstr("cross or touch"));     // runs back
  EXPECT_THAT(defect({{{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}}, {}}), testing::HasSubstr("(5, 0)"));  // touches
  EXPECT_THAT(defect({kSquare, {{{8, 8}, {12, 8}, {8, 12}}}}), testing::HasSubstr("hole 0"));
  EXPECT_THAT(defect({kSquare, {{{20, 20}, {22, 20}, {20, 22}}}}), testing::HasSubstr("outside the outer ring"));
}

TEST(FindDefect, RingsMayTouchInAPlace) {
  EXPECT_EQ(defect({kSquare, {{{0, 5}, {4, 4}, {4, 6}}}}), "none") << "a corner of the hole on a side";
  EXPECT_EQ(defect({kSquare, {{{0, 0}, {4, 1}, {1, 4}}}}), "none") << "corner on corner";
  EXPECT_EQ(defect({kSquare, {{{2, 2}, {4, 2}, {4, 4}}, {{4, 4}, {8, 5}, {5, 8}}}}), "none") << "two holes";
  EXPECT_EQ(defect({{{0, 0}, {10, 0}, {10, 10}, {5, 5}, {0, 10}}, {{{4, 1}, {6, 1}, {5, 5}}}}), "none") << "a bay";
  EXPECT_EQ(defect({{{0, 0}, {10, 0}, {10, 10}, {5, 5}, {0, 10}}, {{{4, 2}, {6, 2}, {6, 5}, {4, 5}}}}), "none")
      << "a corner of the shell on a side of the hole";
}

TEST(FindDefect, RingsMustNotCrossInACornerOrRunAlongEachOther) {
  EXPECT_THAT(defect({kSquare, {{{0, 2}, {4, 4}, {0, 6}}}}), testing::HasSubstr("cross or touch")) << "along a side";
  EXPECT_THAT(defect({kSquare, {{{0, 5}, {4, 4}, {-4, 7}}}}), testing::HasSubstr("cross or touch"));
  EXPECT_THAT(defect({{{0, 0}, {10, 0}, {10, 10}, {5, 5}, {0, 10}}, {{{4, 8}, {5, 2}, {5, 5}}}}),
              testing::HasSubstr("cross or touch"));
  EXPECT_THAT(defect({kSquare, {{{0, 5}, {-4, 4}, {-4, 6}}}}), testing::HasSubstr("outside the outer ring"));
}

TEST(FindDefect, FindsEveryCrossingThatBruteForceFinds) {
  Rng rng(Seed{2});
  const auto turns = [](Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a) > 0; };
  int crossed = 0;
  for (int trial = 0; trial < 400; ++trial) {
    Ring ring;
    const int n = rng.integer(4, 12);
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * (i + rng.uniform(-0.7, 0.7)) / n, r = rng.uniform(1, 3);
      ring.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    bool expected = false;
    for (size_t i = 0; i < ring.size(); ++i) {
      for (size_t j = i + 2; j < ring.size(); ++j) {
        if (i == 0 && j + 1 == ring.size()) continue;
        const Vec2 a = ring[i], b = ring[i + 1], c = ring[j], d = ring[(j + 1) % ring.size()];
        expected |= turns(a, b, c) != turns(a, b, d) && turns(c, d, a) != turns(c, d, b);
      }
    }
    crossed += expected;
    EXPECT_EQ(find_defect({ring, {}}).has_value(), expected) << "trial " << trial;
  }
  EXPECT_GT(crossed, 20);
  EXPECT_LT(crossed, 380);
}

TEST(FindDefect, IsQuickForALongCoast) {
  Ring coast = circle({0, 0}, 1e5, 100000);
  for (size_t i = 0; i < coast.size(); i += 2) coast[i] = 0.97 * coast[i];
  EXPECT_EQ(defect({coast, {}}), "none");
  std::swap(coast[70000], coast[70003]);
  EXPECT_THAT(defect({coast, {}}), testing::HasSubstr("cross"));
}

TEST(FindCrossing, OfTwoRings) {
  EXPECT_FALSE(find_crossing(kSquare, kHole));
  EXPECT_FALSE(find_crossing(kSquare, {}));
  const std::optional<Vec2> at = find_crossing(kSquare, {{5, 5}, {20, 6}, {5, 7}});
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->x, 10, 1e-9);
  EXPECT_TRUE(find_crossing(kSquare, {{10, 5}, {20, 6}, {20, 4}}));
}

TEST(Rasterise, AgreesWithContainsAtCellCentres) {
  Rng rng(Seed{9});
  for (const auto& [width, height] : {std::pair(1, 1), {1, 50}, {50, 1}, {61, 47}}) {
    const GridFrame frame = {width, height, 1.7, -30, 41, {}};
    std::vector<Polygon> polygons;
    for (int k = 0; k < 4; ++k) {
      Polygon polygon = {circle({rng.uniform(-40, 60), rng.uniform(-40, 50)}, rng.uniform(5, 50), rng.integer(3, 40)),
                         {}};
      polygon.holes.push_back(circle(0.2 * polygon.outer[0] + 0.8 * polygon.outer[1], 3, 5));
      polygons.push_back(polygon);
    }
    const Grid<uint8_t> inside = rasterise(polygons, frame);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        bool expected = false;
        for (const Polygon& polygon : polygons) {
          bool odd = contains(polygon.outer, {frame.x(x), frame.y(y)});
          for (const Ring& hole : polygon.holes) odd ^= contains(hole, {frame.x(x), frame.y(y)});
          expected |= odd;
        }
        ASSERT_EQ(inside(x, y), expected ? 1 : 0) << x << ' ' << y;
      }
    }
  }
}

TEST(Rasterise, NeighbouringSquaresShareNoCellAndLeaveNone) {
  const GridFrame frame = GridFrame::centred(20, 20, 1.0);
  const Polygon west = {{{-10, -10}, {0.5, -10}, {0.5, 10}, {-10, 10}}, {}};
  const Polygon east = {{{0.5, -10}, {10, -10}, {10, 10}, {0.5, 10}}, {}};
  const Grid<uint8_t> a = rasterise({west}, frame), b = rasterise({east}, frame);
  for (size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a.cells()[i] + b.cells()[i], 1);
}

double distance_to_ring(Vec2 p, const Ring& ring) {
  double best = 1e300;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], d = ring[(i + 1) % ring.size()] - a;
    const double t = dot(d, d) > 0 ? std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0) : 0.0;
    const Vec2 off = p - (a + t * d);
    best = std::min(best, std::hypot(off.x, off.y));
  }
  return best;
}

TEST(Simplify, KeepsWithinTheTolerance) {
  const Ring ring = circle({3, 4}, 100, 1000);
  const Ring simple = simplify(ring, 1.0);
  EXPECT_LT(simple.size(), 40U);
  for (const Vec2 p : ring) EXPECT_LE(distance_to_ring(p, simple), 1.0 + 1e-9);
  EXPECT_EQ(simplify(ring, 1e6).size(), 3U);
  EXPECT_EQ(simplify(kSquare, 0.1).size(), 4U);
  EXPECT_EQ(simplify_line({{0, 0}, {5, 0.1}, {10, 0}}, 0.5), (Polyline{{0, 0}, {10, 0}}));
  EXPECT_EQ(simplify_line({{0, 0}, {5, 2}, {10, 0}}, 0.5).size(), 3U);
}

TEST(SmoothRing, KeepsTheAreaAndLosesTheCorners) {
  Ring stairs;
  for (int i = 0; i < 40; ++i) stairs.insert(stairs.end(), {{i + 0.0, i + 0.0}, {i + 1.0, i + 0.0}});
  stairs.push_back({0, 60});
  stairs = densify(stairs, 1.0);
  const Ring smooth = smooth_ring(stairs, 10);
  EXPECT_EQ(smooth.size(), stairs.size());
  EXPECT_NEAR(signed_area(smooth), signed_area(stairs), 1e-6 * std::abs(signed_area(stairs)));
  EXPECT_LT(ring_length(smooth), ring_length(stairs));
}

TEST(Densify, SplitsEdgesAndKeepsVertices) {
  const Ring dense = densify(kSquare, 3);
  EXPECT_EQ(dense.size(), 16U);
  EXPECT_EQ(signed_area(dense), 100);
}

}  // namespace
}  // namespace seamount::geom
