#include "seamount/ops/terrain/crop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "seamount/base/error.h"

namespace seamount::terrain {
namespace {

HeightField numbered(int width, int height, double cell_m) {
  GridFrame frame{width, height, cell_m, 5000.0, 9000.0, "EPSG:32604"};
  HeightField terrain(frame);
  for (size_t i = 0; i < terrain.size(); ++i) terrain.data()[i] = static_cast<float>(i);
  return terrain;
}

TEST(Crop, CellsStayWhereTheyAreAndAsTheyAre) {
  const HeightField terrain = numbered(60, 40, 25.0);
  for (const auto& [x, y, w, h] : std::vector<std::array<double, 4>>{
           {5700, 8500, 300, 200}, {5700.1, 8511.7, 301, 26}, {5012, 8990, 10, 10}, {6000, 8200, 25, 700}}) {
    const HeightField part = crop(terrain, {.width_m = w, .height_m = h, .x_m = x, .y_m = y}, {});
    EXPECT_EQ(part.frame().crs, "EPSG:32604");
    for (int j = 0; j < part.height(); ++j)
      for (int i = 0; i < part.width(); ++i) {
        const double column = terrain.frame().column(part.frame().x(i)), row = terrain.frame().row(part.frame().y(j));
        EXPECT_EQ(column, std::round(column));
        EXPECT_EQ(part(i, j), terrain(static_cast<int>(column), static_cast<int>(row)));
      }
    EXPECT_NEAR(part.frame().width_m(), w, 25.0);
    EXPECT_NEAR(part.frame().west_m + 0.5 * part.frame().width_m(), x, 12.51);
  }
}

TEST(Crop, AroundTheSummitAndTheHole) {
  HeightField terrain = numbered(50, 50, 10.0);
  terrain(13, 31) = 1e6F;
  terrain(40, 8) = -50.0F;
  terrain(2, 2) = std::numeric_limits<float>::quiet_NaN();
  const HeightField summit = crop(terrain, {.width_m = 50, .around = Around::highest}, {}),
                    hole = crop(terrain, {.width_m = 50, .around = Around::lowest}, {});
  EXPECT_EQ(summit.width(), 5);
  EXPECT_EQ(summit(2, 2), 1e6F);
  EXPECT_EQ(hole(2, 2), -50.0F);
}

TEST(Crop, WhatReachesBeyondIsCutAndSaidAndWhatLiesBesideIsRefused) {
  const HeightField terrain = numbered(30, 20, 10.0);
  std::vector<std::string> notes;
  RunContext run;
  run.note = [&](const std::string& line) { notes.push_back(line); };
  EXPECT_EQ(crop(terrain, {.width_m = 1000}, run), terrain);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("300 x 200 m of 1000 x 1000 m"), std::string::npos) << notes[0];
  EXPECT_THROW(crop(terrain, {.width_m = 50, .x_m = 0.0, .y_m = 0.0}, {}), InvalidArgument);
  EXPECT_THROW(crop(terrain, {.x_m = 5100.0}, {}), InvalidArgument);
  EXPECT_THROW(crop(HeightField(), {}, {}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::terrain
