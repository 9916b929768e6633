#include "seamount/geom/skeleton/bend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/skeleton/tangles.h"

namespace seamount::geom {
namespace {

Skeleton disc(double radius, int points) {
  Skeleton region = {SkeletonKind::region, {}};
  for (int i = 0; i < points; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / points;
    region.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return region;
}

TEST(Bend, TheHandleItselfMovesByTheDisplacement) {
  for (const Handle kind : {Handle::gaussian, Handle::kelvinlet}) {
    for (const double ratio : {0.0, 0.3, 0.5}) {
      const BendHandle handle = {{3.0, -2.0}, {10.0, 4.0}, 25.0, kind, ratio};
      EXPECT_NEAR(displacement(handle, handle.at).x, 10.0, 1e-12);
      EXPECT_NEAR(displacement(handle, handle.at).y, 4.0, 1e-12);
      double before = 1e9;
      for (double d = 0.0; d < 500.0; d += 10.0) {
        const Vec2 by = displacement(handle, handle.at + d * Vec2{0.6, 0.8});
        EXPECT_LT(std::hypot(by.x, by.y), before);
        before = std::hypot(by.x, by.y);
      }
    }
  }
  const BendHandle gauss = {{0.0, 0.0}, {10.0, 0.0}, 25.0};
  EXPECT_NEAR(displacement(gauss, {30.0, 40.0}).x, 10.0 * std::exp(-2.0), 1e-12);
  // Incompressible, radius 1: a = 1, b = 1/2, force 1.
  const BendHandle grab = {{0.0, 0.0}, {1.0, 0.0}, 1.0, Handle::kelvinlet, 0.5};
  const double r = std::sqrt(1.0 + 4.0), cube = r * r * r;
  EXPECT_NEAR(displacement(grab, {2.0, 0.0}).x, 0.5 / r + 0.5 * 4.0 / cube + 0.5 / cube, 1e-12);
  EXPECT_NEAR(displacement(grab, {0.0, 2.0}).x, 0.5 / r + 0.5 / cube, 1e-12);
  EXPECT_EQ(displacement(grab, {0.0, 2.0}).y, 0.0);
}

TEST(Bend, MovesSplitsAndLocks) {
  const Skeleton line = {SkeletonKind::curve, {{-500.0, 0.0}, {500.0, 0.0}}, {1.0F, 0.0F}};
  const Skeleton result = bent(line, {{0.0, 0.0}, {0.0, 60.0}, 50.0}, true);
  EXPECT_GT(result.points.size(), 40U);
  EXPECT_EQ(result.hold.size(), result.points.size());
  EXPECT_EQ(result.hold.front(), 1.0F);
  EXPECT_EQ(result.hold.back(), 0.0F);
  double highest = 0.0;
  for (size_t i = 1; i < result.points.size(); ++i) {
    highest = std::max(highest, result.points[i].y);
    EXPECT_EQ(result.hold[i] == 1.0F, result.points[i].y > 30.0);
    EXPECT_NEAR(result.points[i].y, 60.0 * std::exp(-result.points[i].x * result.points[i].x / 5000.0), 1e-9);
  }
  EXPECT_NEAR(highest, 60.0, 2.0);
  const Skeleton point = {SkeletonKind::point, {{50.0, 0.0}}};
  EXPECT_NEAR(bent(point, {{0.0, 0.0}, {0.0, 10.0}, 50.0}, false).points[0].y, 10.0 * std::exp(-0.5), 1e-12);
  EXPECT_EQ(moved(line, {1.0, 2.0}).points[1], (Vec2{501.0, 2.0}));
  EXPECT_EQ(held(held(disc(10.0, 8), {10.0, 0.0}, 1.0, 0.5), {10.0, 0.0}, 1.0, 0.0), disc(10.0, 8));
  EXPECT_EQ(held(disc(10.0, 8), {10.0, 0.0}, 1.0, 0.5).hold[0], 0.5F);
}

TEST(Bend, SimpleOutlinesStaySimpleOrTheEditIsRefused) {
  Rng rng(Seed{5});
  int refused = 0, done = 0;
  for (int i = 0; i < 300; ++i) {
    const Skeleton region = disc(100.0, rng.integer(3, 60));
    const BendHandle handle = {{rng.uniform(-150.0, 150.0), rng.uniform(-150.0, 150.0)},
                               {rng.uniform(-200.0, 200.0), rng.uniform(-200.0, 200.0)},
                               rng.uniform(10.0, 120.0),
                               rng.chance(0.5) ? Handle::gaussian : Handle::kelvinlet};
    try {
      const Skeleton result = bent(region, handle, rng.chance(0.5));
      EXPECT_TRUE(find_tangles(result.points, true).empty());
      EXPECT_GT(signed_area(result.points), 0.0);
      ++done;
    } catch (const InvalidArgument& error) {
      EXPECT_EQ(error.field(), "by");
      ++refused;
    }
  }
  EXPECT_GT(done, 100);
  EXPECT_GT(refused, 10);
}

TEST(Bend, BadInput) {
  EXPECT_THROW(bent(disc(10.0, 8), {{0.0, 0.0}, {1.0, 0.0}, 0.0}, false), InvalidArgument);
  EXPECT_THROW(bent(disc(10.0, 8), {{0.0, 0.0}, {NAN, 0.0}, 1.0}, false), InvalidArgument);
  EXPECT_THROW(bent(disc(1e9, 8), {{1e9, 0.0}, {1.0, 0.0}, 1.0}, false), InvalidArgument);
  EXPECT_THROW(held(disc(10.0, 8), {0.0, 0.0}, 1.0, 2.0), InvalidArgument);
}

}  // namespace
}  // namespace seamount::geom
