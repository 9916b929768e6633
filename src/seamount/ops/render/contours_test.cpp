#include "seamount/ops/render/contours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/error.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/render/contour_labels.h"

namespace seamount::render {
namespace {

Ring circle(double radius, bool hill, Vec2 middle = {}) {
  Ring ring;
  for (int i = 0; i < 240; ++i) {
    const double a = (hill ? 1 : -1) * i * 0.026179938779914944;
    ring.push_back(middle + radius * Vec2{std::cos(a), std::sin(a)});
  }
  return ring;
}

ContoursParams bare(int width_px) {
  return {.width_px = width_px, .labels = false, .water = false, .scale_bar = false, .north_arrow = false};
}

int dark_pixels(const Image& image, int x0, int x1, int y0, int y1) {
  int count = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) count += image.pixel(x, y)[0] < 215 ? 1 : 0;
  return count;
}

TEST(RenderContours, LinesAreWhereTheContoursAre) {
  const ContourSet set{GridFrame::centred(100, 50, 10.0), {{10, circle(200, true), -1}}};
  const Image image = contours(set, bare(400), {});
  EXPECT_EQ(image.width, 400);
  EXPECT_EQ(image.height, 200);
  EXPECT_GT(dark_pixels(image, 275, 285, 90, 110), 15) << "the circle's eastern point";
  EXPECT_EQ(dark_pixels(image, 150, 250, 60, 140), 0);
}

TEST(RenderContours, TicksLeadIntoBasins) {
  const auto inside = [](bool hill, bool ticks) {
    ContoursParams params = bare(1000);
    params.basin_ticks = ticks;
    const Image image = contours({GridFrame::centred(50, 50, 10.0), {{10, circle(150, hill), -1}}}, params, {});
    int dark = 0;
    for (int y = 0; y < 1000; ++y) {
      for (int x = 0; x < 1000; ++x) {
        if (std::hypot(x + 0.5 - 500, y + 0.5 - 500) < 297.5) dark += dark_pixels(image, x, x + 1, y, y + 1);
      }
    }
    return dark;
  };
  EXPECT_EQ(inside(true, true), 0);
  EXPECT_EQ(inside(false, false), 0);
  EXPECT_GT(inside(false, true), 40);
}

TEST(RenderContours, IndexLinesAreMultiplesOfTheIntervalAndStronger) {
  ContourSet set{GridFrame::centred(100, 100, 10.0), {}};
  for (int i = 0; i < 5; ++i) set.contours.push_back({150.0 + 50 * i, circle(450 - 80 * i, true), i - 1});
  const Image image = contours(set, bare(1000), {});
  // Level 250 is the third, with radius 290: as wide at its eastern point as twice another one.
  const auto width = [&](int radius) { return dark_pixels(image, 500 + radius - 5, 500 + radius + 5, 500, 501); };
  EXPECT_GT(width(290), width(370));
  EXPECT_EQ(width(210), width(370));
}

TEST(RenderContours, WaterLiesOutsideIslandsAndInLakesBelowTheSea) {
  ContourSet set{GridFrame::centred(100, 100, 10.0),
                 {{0, circle(400, true), -1}, {0, circle(200, false), 0}, {0, circle(80, true), 1}}};
  ContoursParams params = bare(500);
  params.water = true;
  const Image image = contours(set, params, {});
  const Colour sea = image.colour(5, 5), land = image.colour(250 + 150, 250), lake = image.colour(250 + 70, 250);
  EXPECT_NE(sea, land);
  EXPECT_EQ(sea, lake);
  EXPECT_EQ(image.colour(250, 250), land) << "the island in the lake";
  set.contours = {{100, circle(400, true), -1}};
  EXPECT_EQ(contours(set, params, {}).colour(5, 5), land) << "nothing says where the sea is";
}

TEST(RenderContours, EachPieceOfFurnitureCanBeSwitched) {
  const ContourSet set{GridFrame::centred(100, 100, 10.0),
                       {{1200, circle(450, true), -1}, {1250, circle(300, true), 0}}};
  const ContoursParams all{.width_px = 800, .title = "Hill"};
  const Image whole = contours(set, all, {});
  for (bool ContoursParams::*part :
       {&ContoursParams::labels, &ContoursParams::scale_bar, &ContoursParams::north_arrow}) {
    ContoursParams without = all;
    without.*part = false;
    EXPECT_NE(contours(set, without, {}).rgb, whole.rgb);
  }
}

TEST(RenderContours, NothingToDrawIsSaid) {
  EXPECT_THROW(contours({GridFrame::centred(10, 10, 1), {}}, {}, {}), InvalidArgument);
}

TEST(ContourLabels, LieOnStraightStretchesApartAndReadFromTheLeft) {
  const Ring box = geom::densify({{50, 50}, {950, 50}, {950, 950}, {50, 950}}, 5);
  const Ring small = circle(20, true, {500, 500});
  const std::vector<ContourLabel> labels = place_labels({{&box, 100, 60}, {&small, 200, 60}}, 15, 1000, 1000, {});
  EXPECT_GE(labels.size(), 4U);
  for (const ContourLabel& label : labels) {
    EXPECT_EQ(label.height_m, 100) << "the small ring has no room";
    EXPECT_GE(label.along.x, 0.0);
    EXPECT_NEAR(dot(label.along, label.along), 1.0, 1e-12);
    const double off = std::min(std::abs(std::abs(label.at.x - 500) - 450), std::abs(std::abs(label.at.y - 500) - 450));
    EXPECT_LT(off, 5.0);
    for (const ContourLabel& other : labels) {
      if (&other == &label) continue;
      EXPECT_GE(std::hypot(label.at.x - other.at.x, label.at.y - other.at.y), 240.0);
    }
  }
}

}  // namespace
}  // namespace seamount::render
