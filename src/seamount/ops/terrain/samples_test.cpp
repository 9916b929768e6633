#include "seamount/ops/terrain/samples.h"

#include <gtest/gtest.h>

namespace seamount::terrain {
namespace {

HeightField plane(const GridFrame& frame) {
  HeightField terrain(frame);
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) terrain(x, y) = static_cast<float>(2 * frame.x(x) - frame.y(y));
  return terrain;
}

TEST(Samples, LieOnTheOuterSamplesOfTheCentredSquare) {
  const GridFrame source{100, 80, 10, 5000, 9000, "EPSG:32604"};
  const GridFrame frame = square_frame(source, 127);
  EXPECT_DOUBLE_EQ(frame.x(0), source.x(10));
  EXPECT_DOUBLE_EQ(frame.x(126), source.x(89));
  EXPECT_DOUBLE_EQ(frame.y(0), source.y(0));
  EXPECT_DOUBLE_EQ(frame.y(126), source.y(79));
  EXPECT_EQ(frame.crs, source.crs);
}

TEST(Samples, ThatAreFinerShowAPlaneExactly) {
  const HeightField made = samples(plane({33, 40, 10, 0, 0, ""}), {.samples = 65}, {});
  for (int y = 4; y < 61; ++y) {
    for (int x = 4; x < 61; ++x)
      EXPECT_NEAR(made(x, y), 2 * made.frame().x(x) - made.frame().y(y), 1e-3) << x << " " << y;
  }
}

/// Coarser ones are means of whole cells c: over a width h off by at most slope c^2 / 4 h along each axis, 4.9 m here.
TEST(Samples, OfAPlaneAreThePlane) {
  const HeightField terrain = plane({64, 50, 10, 0, 0, ""});
  const HeightField made = samples(terrain, {.samples = 33}, {});
  EXPECT_EQ(made.width(), 33);
  for (int y = 2; y < 31; ++y) {
    for (int x = 2; x < 31; ++x)
      EXPECT_NEAR(made(x, y), 2 * made.frame().x(x) - made.frame().y(y), 4.7) << x << " " << y;
  }
}

TEST(Samples, TakeTheLargestSizeThatTheTerrainFills) {
  const HeightField terrain = plane({128, 200, 10, 0, 0, ""});
  EXPECT_EQ(samples(terrain, {.choices = {33, 65, 129, 257}}, {}).width(), 129);
  EXPECT_EQ(samples(terrain, {.choices = {257, 513}}, {}).width(), 257);
  EXPECT_EQ(samples(terrain, {}, {}).frame(), square_frame(terrain.frame(), 128));
}

TEST(Samples, OfTilesAreWholeTiles) {
  const GridFrame source{100, 70, 10, 0, 0, ""};
  const GridFrame frame = tiled_frame(source, 33);
  EXPECT_EQ((frame.width - 1) % 32, 0);
  EXPECT_EQ((frame.height - 1) % 32, 0);
  EXPECT_DOUBLE_EQ(frame.x(0), source.x(0));
  EXPECT_DOUBLE_EQ(frame.x(frame.width - 1), source.x(99));
  EXPECT_LE(source.y(69) - 1e-6, frame.y(frame.height - 1));
  EXPECT_EQ(tiled_frame({97, 65, 10, 0, 0, ""}, 33), (GridFrame{97, 65, 10, 0, 0, ""}));
}

TEST(Samples, RefuseWhatHasNoTwoSamples) {
  EXPECT_THROW(samples(plane({1, 9, 10, 0, 0, ""}), {}, {}), InvalidArgument);
  EXPECT_THROW(samples(plane({9, 9, 10, 0, 0, ""}), {.samples = 1}, {}), InvalidArgument);
  EXPECT_THROW(samples(plane({9, 9, 10, 0, 0, ""}), {.layout = SampleLayout::tiles, .samples = 1}, {}),
               InvalidArgument);
}

}  // namespace
}  // namespace seamount::terrain
