#include "seamount/geom/polygon/frame_clipping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "seamount/base/rng.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::geom {
namespace {

const GridFrame kFrame = GridFrame::centred(100, 80, 10);  // 1000 m x 800 m

Ring wavy(Vec2 centre, double radius, double wave, int turns) {
  Ring ring;
  for (int i = 0; i < 240; ++i) {
    const double a = 2 * std::numbers::pi * i / 240;
    ring.push_back(centre + radius * (1 + wave * std::sin(turns * a)) * Vec2{std::cos(a), std::sin(a)});
  }
  return ring;
}

TEST(FrameClipping, RingsWithinTheFrameStay) {
  const Ring ring = wavy({0, 0}, 300, 0.1, 5);
  const std::vector<ClippedRing> closed = clip_to_frame({{ring}}, kFrame, 5);
  ASSERT_EQ(closed.size(), 1U);
  EXPECT_EQ(closed[0].ring, ring);
}

TEST(FrameClipping, WhatGoesBeyondIsClosedAlongTheEdge) {
  const Ring east = {{400, -100}, {900, -100}, {900, 100}, {400, 100}};
  const std::vector<ClippedRing> closed = clip_to_frame({{east}}, kFrame, 5);
  ASSERT_EQ(closed.size(), 1U);
  EXPECT_NEAR(signed_area(closed[0].ring), 105.0 * 200.0, 1e-6);
  EXPECT_NEAR(bounding_box(closed[0].ring).high.x, 505, 1e-9);
  Ring hollow = east;
  std::reverse(hollow.begin(), hollow.end());
  EXPECT_NEAR(signed_area(clip_to_frame({{hollow}}, kFrame, 5)[0].ring), -105.0 * 200.0, 1e-6);
}

TEST(FrameClipping, RingsAroundTheFrameBecomeRectanglesAndThoseBesideItGo) {
  const std::vector<Ring> rings = {wavy({0, 0}, 900, 0, 1), wavy({0, 0}, 1200, 0, 1), wavy({3000, 0}, 50, 0, 1)};
  const std::vector<ClippedRing> closed = clip_to_frame(rings, kFrame, 6);
  ASSERT_EQ(closed.size(), 2U);
  EXPECT_NEAR(signed_area(closed[0].ring), 1006.0 * 806.0, 1e-6);
  EXPECT_NEAR(signed_area(closed[1].ring), 1012.0 * 812.0, 1e-6);
  const Ring frame = {{-500, -400}, {500, -400}, {500, 400}, {-500, 400}};
  EXPECT_NEAR(signed_area(clip_to_frame({{frame}}, kFrame, 6)[0].ring), 1012.0 * 812.0, 1e-6);
}

TEST(FrameClipping, ARingThatLeavesSeveralTimesIsCutIntoItsParts) {
  // A comb whose back lies beyond the frame.
  const Ring comb = {{700, -350}, {700, 350},  {300, 350},  {300, 200},
                     {600, 200},  {600, -200}, {300, -200}, {300, -350}};
  const std::vector<ClippedRing> closed = clip_to_frame({{comb}}, kFrame, 2);
  ASSERT_EQ(closed.size(), 2U);
  for (const ClippedRing& part : closed) {
    EXPECT_EQ(part.of, 0U);
    EXPECT_NEAR(signed_area(part.ring), 200.0 * 150.0, 400.0);
  }
}

TEST(FrameClipping, RingsThatNestInTheFrameNestBeyondIt) {
  // Within the frame these nest; beyond it each is closed in a way of its own, so that they cross there.
  for (uint64_t seed = 0; seed < 200; ++seed) {
    Rng rng(Seed{seed});
    const Vec2 centre = {rng.uniform(-700, 700), rng.uniform(-600, 600)};
    std::vector<Ring> rings;
    for (int i = 0; i < 12; ++i) {
      Ring ring = wavy(centre, 150.0 + 90 * i, 0.2, 7);
      const double limit = 600 + 150 * rng.uniform(0, 1);
      for (Vec2& p : ring) p = {std::clamp(p.x, -limit, limit), std::clamp(p.y, -limit, limit)};
      rings.push_back(ring);
    }
    std::vector<Contour> contours;
    for (ClippedRing& ring : clip_to_frame(rings, kFrame, 3)) contours.push_back({0, std::move(ring.ring), -1});
    ASSERT_FALSE(find_contour_crossing(contours).has_value()) << seed;
    for (const Contour& contour : contours) {
      const Box box = bounding_box(contour.ring);
      EXPECT_TRUE(box.low.x >= -503 && box.high.x <= 503 && box.low.y >= -403 && box.high.y <= 403);
    }
  }
}

}  // namespace
}  // namespace seamount::geom
