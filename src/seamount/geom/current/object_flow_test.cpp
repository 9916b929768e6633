#include "seamount/geom/current/object_flow.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "seamount/base/error.h"
#include "seamount/geom/scalar/kelvinlet.h"

namespace seamount::geom {
namespace {

VectorField still(const GridFrame& frame) { return {ScalarField(frame, 0.0F), ScalarField(frame, 0.0F)}; }

Polygon disc(Vec2 centre, double radius) {
  Polygon polygon;
  for (int i = 0; i < 90; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 90.0;
    polygon.outer.push_back(centre + radius * Vec2{std::cos(a), std::sin(a)});
  }
  return polygon;
}

TEST(CurveFlow, BesideAStraightCurveItIsTheKelvinlets) {
  const GridFrame frame = GridFrame::centred(101, 81, 10.0);
  VectorField current = still(frame);
  add_curve_flow(std::vector<CurveFlow>{{{{-3000, 0}, {0, 0}, {3000, 0}}, 60.0, 1.2, 0.5}}, current, {});
  for (int y = 29; y < 52; ++y) {  // within 2 radii
    const Vec2 r{0.0, frame.y(y)};
    const Vec2 expected =
        flow_of({KelvinletKind::grab, {}, 60.0, {1.2, 0}}, r) + flow_of({KelvinletKind::scale, {}, 60.0, {0.5, 0}}, r);
    EXPECT_NEAR(static_cast<double>(current.x(50, y)), expected.x, 0.02) << y;
    EXPECT_NEAR(static_cast<double>(current.y(50, y)), expected.y, 0.02) << y;
  }
  EXPECT_EQ(current.x(50, 10), 0.0F);  // 300 m away
  EXPECT_EQ(current.y(50, 10), 0.0F);
}

TEST(CurveFlow, FollowsABendWithoutAJump) {
  const GridFrame frame = GridFrame::centred(121, 121, 5.0);
  Polyline bend;
  for (int i = 0; i <= 40; ++i) {
    const double a = std::numbers::pi * i / 40.0;
    bend.push_back({150.0 * std::cos(a), 150.0 * std::sin(a) - 60.0});
  }
  VectorField current = still(frame);
  add_curve_flow(std::vector<CurveFlow>{{bend, 50.0, 1.0, 0.0}}, current, {});
  EXPECT_LT(current.x(60, 42), -0.9F);  // at the top of the arc it flows west
  for (int y = 1; y < 121; ++y)
    for (int x = 1; x < 121; ++x) {
      ASSERT_LT(std::abs(current.x(x, y) - current.x(x - 1, y)), 0.2F) << x << ' ' << y;
      ASSERT_LT(std::abs(current.y(x, y) - current.y(x, y - 1)), 0.2F) << x << ' ' << y;
    }
}

TEST(RegionFlow, PushesAwayFromTheOutlineOnBothSidesAndEndsAtTheReach) {
  const GridFrame frame = GridFrame::centred(121, 121, 10.0);
  VectorField current = still(frame);
  const std::vector<RegionFlow> island = {{disc({0, 0}, 250.0), 200.0, 0.8, 0.0}};
  add_region_flow(island, current, {});
  EXPECT_NEAR(current.x(60 + 25, 60), 0.8F, 0.02F);  // on the coast
  EXPECT_GT(current.x(60 + 20, 60), 0.5F);           // inside, still outwards
  EXPECT_GT(current.x(60 + 30, 60), 0.5F);
  EXPECT_EQ(current.x(60 + 46, 60), 0.0F);
  EXPECT_EQ(current.x(60, 60), 0.0F);
  EXPECT_NEAR(current.y(60, 60 - 25), 0.8F, 0.02F);  // north of it, northwards
}

TEST(RegionFlow, WavesRunAshore) {
  const GridFrame frame = GridFrame::centred(121, 121, 10.0);
  VectorField current = still(frame);
  add_region_flow(std::vector<RegionFlow>{{disc({0, 0}, 250.0), 300.0, 0.0, 0.4}}, current, {});
  EXPECT_NEAR(current.x(60 + 35, 60), -0.4F, 0.01F);  // a third of the reach outside
  EXPECT_EQ(current.x(60 + 20, 60), 0.0F);            // not inside
}

TEST(RegionFlow, BetweenTwoIslandsPushesCancel) {
  const GridFrame frame = GridFrame::centred(161, 81, 10.0);
  VectorField current = still(frame);
  add_region_flow(
      std::vector<RegionFlow>{{disc({-350, 0}, 200.0), 250.0, 0.5, 0.0}, {disc({350, 0}, 200.0), 250.0, 0.5, 0.0}},
      current, {});
  EXPECT_NEAR(current.x(80, 40), 0.0F, 1e-3F);
  EXPECT_GT(current.x(80 - 10, 40), 0.05F);
  EXPECT_LT(current.x(80 + 10, 40), -0.05F);
}

TEST(ObjectFlow, SameBitsOnAnyNumberOfThreadsAndNothingFromFarAway) {
  const GridFrame frame = GridFrame::centred(90, 70, 10.0);
  std::vector<RegionFlow> regions;
  std::vector<CurveFlow> curves;
  for (int i = 0; i < 150; ++i) {
    const Vec2 at{13.0 * (i % 40) - 250.0, 9.0 * (i % 37) - 160.0};
    regions.push_back({disc(at, 20.0 + i % 7), 60.0, 0.3, 0.1});
    curves.push_back({{at, at + Vec2{40, 15}, at + Vec2{60, -10}}, 15.0, 0.4, -0.1});
  }
  RunContext one, four;
  one.threads = 1;
  four.threads = 4;
  VectorField a = still(frame), b = still(frame);
  add_region_flow(regions, a, one);
  add_curve_flow(curves, a, one);
  add_region_flow(regions, b, four);
  add_curve_flow(curves, b, four);
  EXPECT_EQ(a, b);
  VectorField far = still(frame);
  add_region_flow(std::vector<RegionFlow>{{disc({1e7, 0}, 20.0), 60.0, 0.3, 0.1}}, far, {});
  add_curve_flow(std::vector<CurveFlow>{{{{1e7, 0}, {1e7, 50}}, 15.0, 0.4, -0.1}}, far, {});
  EXPECT_EQ(far, still(frame));
}

TEST(ObjectFlow, NamesWhatIsWrong) {
  VectorField current = still(GridFrame::centred(8, 8, 10.0));
  try {
    add_curve_flow(std::vector<CurveFlow>{{{{0, 0}, {1, 1}}}, {{{0, 0}, {0, 0}}}}, current, {});
    FAIL();
  } catch (const InvalidArgument& e) {
    EXPECT_EQ(e.field(), "curves[1]");
  }
  EXPECT_THROW(add_region_flow({{{disc({0, 0}, 5.0), 0.0}}}, current, {}), InvalidArgument);
  EXPECT_THROW(add_region_flow({{{{{{0, 0}, {1, 1}}, {}}}}}, current, {}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::geom
