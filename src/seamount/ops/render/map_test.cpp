#include "seamount/ops/render/map.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "seamount/base/error.h"
#include "seamount/ops/render/test_terrain.h"

namespace seamount::render {
namespace {

MapParams bare(int width_px) {
  MapParams params;
  params.width_px = width_px;
  params.legend = params.scale_bar = params.north_arrow = params.contours = params.coast = false;
  return params;
}

TEST(Map, WithoutFurnitureIsTheTerrainAlone) {
  const HeightField terrain = test_island(60, 40, 9000.0, 600.0);
  const Image image = map(terrain, nullptr, bare(240), {});
  EXPECT_EQ(image.width, 240);
  EXPECT_EQ(image.height, 160);
}

TEST(Map, EachPieceOfFurnitureCanBeSwitched) {
  const HeightField terrain = test_island(80, 80, 9000.0, 600.0);
  const LabelMap labels = test_labels(terrain);
  const MapParams all{.width_px = 500, .title = "Island"};
  const Image whole = map(terrain, &labels, all, {});
  EXPECT_EQ(whole.width, 500);
  for (bool MapParams::*part : {&MapParams::contours, &MapParams::coast, &MapParams::reef_crest, &MapParams::legend,
                                &MapParams::scale_bar, &MapParams::north_arrow}) {
    MapParams without = all;
    without.*part = false;
    EXPECT_NE(map(terrain, &labels, without, {}), whole);
  }
  MapParams untitled = all;
  untitled.title.clear();
  EXPECT_LT(map(terrain, &labels, untitled, {}).height, whole.height);
}

TEST(Map, DrawsLakesRiversRidgesAndPeaksWhereTheyAre) {
  const HeightField terrain(GridFrame::centred(100, 100, 10.0), 50.0F);
  Drawing lakes, rivers, ridges, peaks;
  lakes.areas.push_back({"lake 1", {{{{100, 100}, {300, 100}, {300, 300}, {100, 300}}, {}}}});
  rivers.lines.push_back({{{-400, -200}, {400, -200}}, 3.0, false, {{"order", 3.0}}});
  ridges.lines.push_back({{{-400, -300}, {400, -300}}, 1.0});
  peaks.points.push_back({{-250, 250}, 812.0, {{"height_m", 812.0}}});
  const MapParams params = bare(200);
  const Image none = map(terrain, nullptr, params, {});
  const auto changed = [&](const MapDrawings& drawings, int x, int y) {
    const Image image = map(terrain, nullptr, drawings, params, {});
    return !std::equal(image.pixel(x, y), image.pixel(x, y) + 3, none.pixel(x, y));
  };
  // 5 m a pixel, north up: (200, 200) is at (140, 60).
  EXPECT_TRUE(changed({.lakes = &lakes}, 140, 60));
  EXPECT_FALSE(changed({.lakes = &lakes}, 60, 60));
  EXPECT_TRUE(changed({.rivers = &rivers}, 100, 140));
  EXPECT_FALSE(changed({.rivers = &rivers}, 100, 120));
  EXPECT_TRUE(changed({.ridges = &ridges}, 100, 160));
  EXPECT_TRUE(changed({.peaks = &peaks}, 50, 50));
  EXPECT_EQ(map(terrain, nullptr, MapDrawings{}, params, {}), none);
  HeightField placed = terrain;
  GridFrame there = placed.frame();
  there.crs = "EPSG:32605";
  placed.set_frame(there);
  rivers.crs = "EPSG:32606";
  EXPECT_THROW(map(placed, nullptr, {.rivers = &rivers}, params, {}), IncompatibleInputs);
}

TEST(Map, DrawsCurrentsAsArrowsAsLongAsTheyAreFast) {
  const HeightField terrain(GridFrame::centred(100, 100, 10.0), -50.0F);
  VectorField current{ScalarField(terrain.frame(), 1.0F), ScalarField(terrain.frame(), 0.0F)};
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x)
      if (x >= 50) current.x(x, y) = x < 75 ? 0.5F : 0.0F;
  MapParams params = bare(400);
  params.arrow_spacing_px = 40.0;
  const Image none = map(terrain, nullptr, params, {}),
              image = map(terrain, nullptr, {.current = &current}, params, {});
  const auto changed = [&](int from, int to) {  // pixels of a row through the middles of arrows
    int count = 0;
    for (int x = from; x < to; ++x)
      count += std::equal(image.pixel(x, 20), image.pixel(x, 20) + 3, none.pixel(x, 20)) ? 0 : 1;
    return count;
  };
  EXPECT_GT(changed(0, 160), 130);  // four arrows, almost without a gap
  EXPECT_GT(changed(200, 280), 30);
  EXPECT_LT(changed(200, 280), 60);  // half as long
  EXPECT_EQ(changed(330, 400), 0);   // still water
  params.legend = true;
  EXPECT_GT(map(terrain, nullptr, {.current = &current}, params, {}).height, map(terrain, nullptr, params, {}).height);
  const VectorField other{ScalarField(GridFrame::centred(9, 9, 1.0), 1.0F),
                          ScalarField(GridFrame::centred(9, 9, 1.0), 1.0F)};
  EXPECT_THROW(map(terrain, nullptr, {.current = &other}, params, {}), IncompatibleInputs);
}

TEST(Map, TheCoastHasNoJumpOfColour) {
  // An even slope from -20 m to +20 m: neighbouring columns differ by little all the way.
  HeightField slope(GridFrame::centred(400, 8, 10.0));
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 400; ++x) slope(x, y) = 0.1F * static_cast<float>(x - 200);
  }
  const Image image = map(slope, nullptr, bare(400), {});
  for (int x = 1; x < 400; ++x) {
    const Colour a = image.colour(x - 1, 4), b = image.colour(x, 4);
    EXPECT_LE(std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b), 16) << x;
  }
}

TEST(Map, AnAtollsSheetIsNotFullOfLines) {
  HeightField terrain = test_island(220, 220, 12000.0, 0.0);
  for (float& h : terrain.cells())
    if (h > -2.0F) h += 3.5F;  // islets, the only land
  MapParams params = bare(660);
  const Image plain = map(terrain, nullptr, params, {});
  params.contours = true;
  const auto lined = [&](const MapParams& with) {
    const Image image = map(terrain, nullptr, with, {});
    int pixels = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const Colour a = image.colour(x, y), b = plain.colour(x, y);
        pixels += std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) > 12 ? 1 : 0;
      }
    return static_cast<double>(pixels) / (image.width * image.height);
  };
  EXPECT_GT(lined(params), 0.002);
  EXPECT_LT(lined(params), 0.06);
  params.contour_interval_m = 2.0;  // what is asked for is drawn
  EXPECT_GT(lined(params), 0.1);
}

TEST(Map, RegionsNeedLabels) {
  const HeightField terrain = test_island(30, 30, 9000.0, 600.0);
  MapParams params = bare(90);
  params.theme = MapTheme::regions;
  EXPECT_THROW(map(terrain, nullptr, params, {}), IncompatibleInputs);
  const LabelMap labels = test_labels(terrain);
  EXPECT_NE(map(terrain, &labels, params, {}), map(terrain, &labels, bare(90), {}));
}

TEST(Map, ALandModelsFlatSeaIsDrawnAsSea) {
  HeightField terrain(GridFrame::centred(60, 60, 90.0), 0.0F);
  for (int y = 20; y < 40; ++y) {
    for (int x = 20; x < 40; ++x) terrain(x, y) = 150.0F;
  }
  const Image image = map(terrain, nullptr, bare(60), {});
  EXPECT_GT(image.colour(5, 5).b, image.colour(5, 5).r + 20);
}

TEST(Map, OddShapesAndThreads) {
  for (const auto& [w, h] : {std::pair{1, 1}, {1, 6}, {50, 2}}) {
    const HeightField terrain(GridFrame::centred(w, h, 25.0), 12.0F);
    EXPECT_EQ(map(terrain, nullptr, {.width_px = 120}, {}).width, 120);
  }
  const HeightField terrain = test_island(70, 50, 9000.0, 600.0);
  EXPECT_EQ(map(terrain, nullptr, {.width_px = 400}, {.threads = 1}),
            map(terrain, nullptr, {.width_px = 400}, {.threads = 2}));
}

}  // namespace
}  // namespace seamount::render
