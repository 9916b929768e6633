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

/// What a run says.
struct Listener {
  std::vector<std::string> said;
  RunContext run;
  Listener() {
    run.note = [this](const std::string& line) { said.push_back(line); };
  }
};

TEST(Samples, OfTilesAreWholeTilesOfTheSameCells) {
  for (const auto& [width, height, size] :
       {std::tuple{100, 70, 33}, {97, 65, 33}, {2, 5, 2}, {1400, 9, 257}, {1, 1, 4}}) {
    const HeightField terrain = plane({width, height, 10, 0, 0, "EPSG:32604"});
    Listener listener;
    const HeightField tiled = samples(terrain, {.layout = SampleLayout::tiles, .samples = size}, listener.run);
    EXPECT_EQ((tiled.width() - 1) % (size - 1), 0);
    EXPECT_EQ((tiled.height() - 1) % (size - 1), 0);
    EXPECT_GE(tiled.width(), std::max(width, size));
    EXPECT_LT(tiled.width(), std::max(width, 2) + size - 1) << "no tile without ground";
    EXPECT_EQ(tiled.frame().x(0), terrain.frame().x(0));
    EXPECT_EQ(tiled.frame().y(0), terrain.frame().y(0));
    EXPECT_EQ(tiled.frame().cell_m, 10);
    EXPECT_EQ(listener.said.empty(), tiled.frame() == terrain.frame());
    for (int y = 0; y < tiled.height(); ++y)
      for (int x = 0; x < tiled.width(); ++x) ASSERT_EQ(tiled(x, y), terrain.clamped(x, y));
  }
}

TEST(Samples, ThatAreCutOffAreSaidInMetres) {
  Listener listener;
  samples(plane({140, 91, 10, 0, 0, ""}), {.samples = 91}, listener.run);
  EXPECT_EQ(listener.said, std::vector<std::string>{"cut off to fit: 245 m in the west, 245 m in the east"});
  Listener square;
  samples(plane({90, 90, 10, 0, 0, ""}), {.samples = 129}, square.run);
  EXPECT_TRUE(square.said.empty());
  samples(plane({90, 90, 10, 0, 0, ""}), {.samples = 33}, square.run);
  EXPECT_EQ(square.said, std::vector<std::string>{"cells of 27.8125 m instead of 10 m: finer detail is averaged"});
}

TEST(Samples, OfAPaddedSquareHoldTheWholeTerrain) {
  const HeightField terrain = plane({60, 31, 10, 500, 900, ""});
  Listener listener;
  const HeightField made = samples(terrain, {.samples = 60, .fit = SquareFit::pad}, listener.run);
  EXPECT_EQ(made.width(), 60);
  EXPECT_EQ(made.height(), 60);
  EXPECT_EQ(listener.said, std::vector<std::string>{
                               "added to fit, as high as the terrain's edge: 140 m in the north, 150 m in the south"});
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) EXPECT_NEAR(made(x, y), terrain.clamped(x, y - 14), 1e-3) << x << " " << y;
}

TEST(Samples, OfTheWholeCoverItWithSquareCells) {
  const HeightField terrain = plane({61, 40, 10, 500, 900, ""});
  EXPECT_EQ(samples(terrain, {.layout = SampleLayout::whole}, {}), terrain);
  for (const int size : {31, 61, 90, 121, 200}) {
    Listener listener;
    const HeightField made = samples(terrain, {.layout = SampleLayout::whole, .samples = size}, listener.run);
    EXPECT_EQ(made.width(), size);
    EXPECT_NEAR(made.frame().x(0), 505, 1e-9);
    EXPECT_NEAR(made.frame().x(size - 1), 1105, 1e-9);
    EXPECT_LE(made.frame().y(made.height() - 1), 505 + 1e-9) << "the last row is covered";
    EXPECT_GT(made.frame().y(made.height() - 1), 505 - made.cell_m());
    std::erase_if(listener.said, [](const std::string& line) { return line.starts_with("cells"); });
    EXPECT_EQ(listener.said.empty(), std::abs(made.frame().y(made.height() - 1) - 505) < 0.005);
  }
  const HeightField tall = plane({40, 61, 10, 500, 900, ""});
  EXPECT_EQ(samples(tall, {.layout = SampleLayout::whole, .samples = 121}, {}).height(), 121);
}

TEST(Samples, RefuseWhatHasNoTwoSamples) {
  EXPECT_THROW(samples(plane({1, 9, 10, 0, 0, ""}), {}, {}), InvalidArgument);
  EXPECT_THROW(samples(plane({9, 9, 10, 0, 0, ""}), {.samples = 1}, {}), InvalidArgument);
  EXPECT_THROW(samples(plane({9, 9, 10, 0, 0, ""}), {.layout = SampleLayout::tiles, .samples = 1}, {}),
               InvalidArgument);
}

}  // namespace
}  // namespace seamount::terrain
