#include "seamount/ops/render/river_cover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "seamount/base/error.h"
#include "seamount/ops/render/texture.h"

namespace seamount::render {
namespace {

Drawing river(Polyline points, double width_m) {
  Drawing drawing;
  ValuedLine line{std::move(points), 3.0};
  line.attributes = {{"width_m", width_m}};
  drawing.lines.push_back(line);
  return drawing;
}

TEST(RiverCover, CoversTheAreaOfTheLines) {
  const GridFrame frame = GridFrame::centred(200, 150, 20.0);
  for (const double width : {2.0, 11.0, 20.0, 33.0, 150.0}) {
    for (const Polyline& line : {Polyline{{-1500, 130}, {1500, 130}}, Polyline{{-1400, -900}, {1300, 1000}}}) {
      const ScalarField cover = river_cover(river(line, width), frame, {});
      const double area =
          400.0 * std::accumulate(cover.cells().begin(), cover.cells().end(), 0.0, [](double sum, float c) {
            EXPECT_GE(c, 0.0F);
            EXPECT_LE(c, 1.0F);
            return sum + static_cast<double>(c);
          });
      const double length = std::hypot(line[1].x - line[0].x, line[1].y - line[0].y);
      EXPECT_NEAR(area, length * width, 0.25 * length * width + 4.0 * width * width) << width;
    }
  }
}

TEST(RiverCover, WhatLiesOutsideIsCutAndOtherSystemsAreRefused) {
  GridFrame frame = GridFrame::centred(20, 20, 10.0);
  const ScalarField far = river_cover(river({{5000, 5000}, {1e12, 1e12}}, 50.0), frame, {});
  for (const float share : far.cells()) EXPECT_EQ(share, 0.0F);
  frame.crs = "EPSG:32604";
  Drawing other = river({{0, 0}, {50, 0}}, 50.0);
  other.crs = "EPSG:32605";
  EXPECT_THROW(river_cover(other, frame, {}), IncompatibleInputs);
}

TEST(RiverCover, ATextureShowsARiverWhereItRuns) {
  const HeightField plain(GridFrame::centred(100, 100, 10.0), 60.0F);
  const Drawing drawing = river({{-600, 205}, {600, 205}}, 60.0);
  const Image image = texture(plain, Shown{.rivers = &drawing}, {.size_px = 100}, {});
  const Colour wet = image.colour(50, 29), dry = image.colour(50, 70);
  EXPECT_LT(wet.g, dry.g);
  EXPECT_GT(wet.b - wet.r, dry.b - dry.r);
  EXPECT_EQ(texture(plain, Shown{.rivers = &drawing}, {.size_px = 100, .water = false}, {}),
            texture(plain, Shown{}, {.size_px = 100, .water = false}, {}));
}

}  // namespace
}  // namespace seamount::render
