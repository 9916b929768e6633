#include "seamount/ops/contour/move/smooth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/contour/move/test_contours.h"

namespace seamount::contour {
namespace {

Ring star(int points, double radius, double depth) {
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double a = 2.0 * std::numbers::pi * i / points;
    ring.push_back((radius + (i % 2 == 0 ? depth : -depth)) * Vec2{std::cos(a), std::sin(a)});
  }
  return ring;
}

std::vector<size_t> all_of(const ContourSet& set) {
  std::vector<size_t> all(set.contours.size());
  for (size_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

TEST(Smooth, KeepsTheAreaAndShortensTheLine) {
  const Ring ring = star(80, 1000, 60);
  const Ring smooth = smoothed_ring(ring, std::vector<char>(ring.size(), 0), {200, 1.0, 2});
  EXPECT_NEAR(geom::signed_area(smooth), geom::signed_area(ring), 1e-9 * geom::signed_area(ring));
  EXPECT_LT(geom::ring_length(smooth), 0.6 * geom::ring_length(ring));
  EXPECT_GT(geom::ring_length(smooth), 0.99 * 2 * std::numbers::pi * 995);
}

TEST(Smooth, AveragesOverArcLengthNotOverPoints) {
  // The same square with points crowded on one side: the result is the same curve.
  const Ring even = geom::densify({{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}}, 10);
  Ring crowded = geom::densify({{0, 0}, {1000, 0}}, 1);
  crowded.resize(1000);
  for (const Vec2 p : geom::densify({{1000, 0}, {1000, 1000}, {0, 1000}, {0, 0}}, 10))
    if (!(p.y == 0 && p.x < 1000)) crowded.push_back(p);
  const Smoothing smoothing{150, 1.0, 1};
  const Ring a = smoothed_ring(even, std::vector<char>(even.size(), 0), smoothing);
  const Ring b = smoothed_ring(crowded, std::vector<char>(crowded.size(), 0), smoothing);
  EXPECT_NEAR(a[0].x, b[0].x, 0.5);
  EXPECT_NEAR(a[0].y, b[0].y, 0.5);
  EXPECT_NEAR(a[50].y, b[500].y, 0.5);
}

TEST(Smooth, PinnedPointsStay) {
  const Ring ring = star(40, 1000, 60);
  std::vector<char> pinned(40, 0);
  pinned[7] = pinned[8] = 1;
  const Ring smooth = smoothed_ring(ring, pinned, {300, 1.0, 3});
  EXPECT_EQ(smooth[7], ring[7]);
  EXPECT_EQ(smooth[8], ring[8]);
  EXPECT_FALSE(smooth[20] == ring[20]);
}

TEST(Smooth, KeepsContoursApartHoweverStrong) {
  for (uint64_t seed = 0; seed < 3; ++seed) {
    ContourSet set = noise_contours(seed, 160, 60);
    const ContourSet before = set;
    const Smoothed report = smooth_contours(set, all_of(set), {2000, 1.0, 3}, {});
    EXPECT_TRUE(is_sound(set)) << seed;
    EXPECT_TRUE(report.where.has_value());
    for (size_t i = 0; i < set.contours.size(); ++i) {
      const double area = geom::signed_area(before.contours[i].ring);
      EXPECT_NEAR(geom::signed_area(set.contours[i].ring), area, 1e-6 * std::abs(area));
    }
  }
}

TEST(Smooth, GentleSmoothingIsHardlyLimited) {
  ContourSet set = noise_contours(4, 160, 150);
  const Smoothed report = smooth_contours(set, all_of(set), {60, 1.0, 1}, {});
  EXPECT_TRUE(is_sound(set));
  EXPECT_LT(report.limited, 20U);
}

TEST(Smooth, ContoursThatWereNotChosenStay) {
  ContourSet set = noise_contours(5, 120, 100);
  const ContourSet before = set;
  smooth_contours(set, {0, 2}, {300, 1.0, 2}, {});
  EXPECT_FALSE(set.contours[0] == before.contours[0]);
  EXPECT_EQ(set.contours[1], before.contours[1]);
  EXPECT_TRUE(is_sound(set));
}

}  // namespace
}  // namespace seamount::contour
