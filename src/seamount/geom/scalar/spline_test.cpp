#include "seamount/geom/scalar/spline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

double length(Vec2 a) { return std::hypot(a.x, a.y); }

TEST(CatmullRom, PassesThroughEveryControlPointInSmallSteps) {
  const Polyline control = {{0, 0}, {100, 20}, {105, 25}, {90, 300}, {-500, 310}};
  const Polyline line = sample_catmull_rom(control, 5.0);
  auto at = line.begin();
  for (const Vec2 p : control) {
    at = std::find(at, line.end(), p);
    ASSERT_NE(at, line.end());
  }
  EXPECT_EQ(line.front(), control.front());
  EXPECT_EQ(line.back(), control.back());
  for (size_t i = 1; i < line.size(); ++i) EXPECT_LE(length(line[i] - line[i - 1]), 5.0 * 1.05);
}

TEST(CatmullRom, KeepsAStraightLineStraight) {
  for (const Vec2 p : sample_catmull_rom({{0, 0}, {10, 10}, {12, 12}, {50, 50}}, 1.0)) EXPECT_NEAR(p.x, p.y, 1e-9);
}

TEST(CatmullRom, TurnsSmoothly) {
  const Polyline line = sample_catmull_rom({{0, 0}, {100, 0}, {100, 100}, {0, 100}}, 0.5);
  for (size_t i = 2; i < line.size(); ++i) {
    const Vec2 a = line[i - 1] - line[i - 2], b = line[i] - line[i - 1];
    EXPECT_GT(dot(a, b), 0.98 * length(a) * length(b));
  }
}

TEST(CatmullRom, TakesRepeatedAndFewPoints) {
  EXPECT_TRUE(sample_catmull_rom({}, 1).empty());
  EXPECT_EQ(sample_catmull_rom({{1, 2}}, 1).size(), 1U);
  EXPECT_EQ(sample_catmull_rom({{1, 2}, {1, 2}}, 1).size(), 1U);
  for (const Vec2 p : sample_catmull_rom({{0, 0}, {0, 0}, {5, 0}, {5, 0}, {9, 3}}, 1)) EXPECT_TRUE(std::isfinite(p.x));
  EXPECT_THROW(sample_catmull_rom({{0, 0}, {1, 1}}, 0), InvalidArgument);
}

TEST(CatmullRom, RefusesALineThatIsTooLongForItsDetail) {
  EXPECT_THROW(sample_catmull_rom({{-2147483649.0, 0}, {0, 0}}, 1.0), InvalidArgument);
  EXPECT_THROW(sample_catmull_rom({{-1e300, 0}, {1e300, 0}}, 1.0), InvalidArgument);
  EXPECT_NO_THROW(sample_catmull_rom({{-2147483649.0, 0}, {0, 0}}, 1e6));
}

TEST(ClosestOnPolyline, AgreesWithDenseSampling) {
  Rng rng(Seed{4});
  Polyline line;
  for (int i = 0; i < 12; ++i) line.push_back({rng.uniform(-50, 50), rng.uniform(-50, 50)});
  for (int trial = 0; trial < 200; ++trial) {
    const Vec2 p = {rng.uniform(-80, 80), rng.uniform(-80, 80)};
    const Closest closest = closest_on_polyline(line, p);
    double best = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i + 1 < line.size(); ++i) {
      for (int k = 0; k <= 400; ++k)
        best = std::min(best, length(p - (line[i] + (k / 400.0) * (line[i + 1] - line[i]))));
    }
    EXPECT_NEAR(closest.distance, best, 0.02);
    EXPECT_LE(closest.distance, best + 1e-9);
    EXPECT_NEAR(length(closest.point - p), closest.distance, 1e-9);
    EXPECT_NEAR(length(closest.tangent), 1.0, 1e-9);
  }
}

TEST(ClosestOnPolyline, TangentIsContinuousAndAlongIsTheLength) {
  const Polyline corner = {{0, 0}, {100, 0}, {100, 100}};
  Vec2 before = closest_on_polyline(corner, {0, -1}).tangent;
  double along = 0;
  for (int i = 1; i <= 400; ++i) {
    const Vec2 p = i <= 200 ? Vec2{i * 0.5, 0.0} : Vec2{100.0, (i - 200) * 0.5};
    const Closest closest = closest_on_polyline(corner, p);
    EXPECT_LT(length(closest.tangent - before), 0.02);
    EXPECT_NEAR(closest.along, i * 0.5, 1e-9);
    EXPECT_GE(closest.along, along);
    along = closest.along;
    before = closest.tangent;
  }
  EXPECT_NEAR(before.y, 1.0, 1e-9);
}

TEST(ClosestOnPolyline, OnePointAndNone) {
  const Closest closest = closest_on_polyline({{3, 4}}, {0, 0});
  EXPECT_DOUBLE_EQ(closest.distance, 5.0);
  EXPECT_EQ(closest.tangent, Vec2{});
  EXPECT_THROW(closest_on_polyline({}, {0, 0}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::geom
