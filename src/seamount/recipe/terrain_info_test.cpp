#include "seamount/recipe/terrain_info.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/error.h"
#include "seamount/io/holds_heights.h"
#include "seamount/io/raster.h"
#include "seamount/recipe/file_info.h"

namespace seamount::recipe {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Key;
using ::testing::Not;
using ::testing::Pair;
using ::testing::StartsWith;

std::string file(const char* name) { return ::testing::TempDir() + "seamount_info_" + name; }

/// Cones of 300 m, 500 m and 200 m on a sea floor, 20 m cells; the frame's north-west corner is a place in Iceland.
HeightField cones(const std::string& crs) {
  HeightField terrain(
      GridFrame{.width = 120, .height = 60, .cell_m = 20, .west_m = 600000, .north_m = 7100000, .crs = crs});
  const GridFrame& frame = terrain.frame();
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 120; ++x) {
      double height = -100;
      for (const auto& [column, row, peak] : {std::tuple{20, 30, 300.0}, {60, 20, 500.0}, {100, 40, 200.0}})
        height = std::max(height, peak - 0.8 * frame.cell_m * std::hypot(x - column, y - row));
      terrain(x, y) = static_cast<float>(height);
    }
  }
  return terrain;
}

TEST(TerrainInfo, TellsThePeaksFromTheHighestOn) {
  for (const char* name : {"cones.tif", "cones.r16", "cones.exr"}) {
    io::write_heights(cones(""), file(name));
    const io::FileInfo info = describe_file(file(name));
    EXPECT_THAT(info, Contains(Pair("peak 1", HasSubstr("500 m at x 601210 m, y 7099590 m"))));
    EXPECT_THAT(info, Contains(Pair("peak 2", StartsWith("300 m"))));
    EXPECT_THAT(info, Contains(Pair("peak 3", StartsWith("200 m"))));
    EXPECT_THAT(info, Not(Contains(Key("peak 4"))));
  }
  io::write_heights(cones("EPSG:32627"), file("placed.tif"));
  EXPECT_THAT(describe_file(file("placed.tif")),
              Contains(Pair("peak 1", HasSubstr("longitude -18.92988, latitude 64.00837"))));
}

TEST(TerrainInfo, HasNoPeaksOfMasksFieldsAndSeaFloors) {
  Mask mask(GridFrame::centred(20, 20, 10.0), 0.0F);
  mask(10, 10) = 1;
  io::write_mask(mask, file("mask.tif"));
  io::write_mask(mask, file("mask.png"));
  io::write_field(mask, file("field.tif"));
  io::write_field(mask, file("field.exr"));
  HeightField deep = mask;
  for (float& height : deep.cells()) height -= 50;
  io::write_heights(deep, file("deep.tif"));
  for (const char* name : {"mask.tif", "mask.png", "field.tif", "field.exr"})
    EXPECT_FALSE(io::holds_heights(file(name))) << name;
  EXPECT_TRUE(io::holds_heights(file("deep.tif")));
  for (const char* name : {"mask.tif", "mask.png", "field.tif", "field.exr", "deep.tif"})
    EXPECT_THAT(describe_file(file(name)), Not(Contains(Key("peak 1")))) << name;
}

TEST(TerrainInfo, TellsWhatLiesAtAPlace) {
  const HeightField terrain = cones("EPSG:32627");
  io::write_heights(terrain, file("at.tif"));
  LabelMap labels(terrain.frame(), Region::abyss);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 120; ++x)
      if (terrain(x, y) > 0) labels(x, y) = Region::mountain;
  io::write_labels(labels, file("labels.tif"));
  const Vec2 flank{601310, 7099590};  // 100 m east of the highest peak
  const io::FileInfo info = describe_place(file("at.tif"), {flank, false, file("labels.tif")});
  EXPECT_THAT(info, Contains(Pair("height", "420 m")));
  EXPECT_THAT(info, Contains(Pair("slope", HasSubstr("38."))));  // atan(0.8) = 38.66
  EXPECT_THAT(info, Contains(Pair("region", "mountain")));
  EXPECT_THAT(info, Contains(Pair("on the globe", HasSubstr("latitude 64.0"))));
  io::write_field(terrain, file("value.tif"));
  EXPECT_THAT(describe_place(file("value.tif"), {flank, false, ""}), Contains(Pair("value", "420")));
  EXPECT_THROW(describe_place(file("at.tif"), {{599999, 7099590}, false, ""}), InvalidArgument);
  io::write_heights(cones(""), file("local.tif"));
  EXPECT_THROW(describe_place(file("local.tif"), {{-18, 64}, true, ""}), InvalidArgument);
}

TEST(TerrainInfo, DegreesAndMetresAreTheSamePlace) {
  io::write_heights(cones("EPSG:32627"), file("both.tif"));
  // What the command prints of one is what it takes of the other.
  const io::FileInfo metres = describe_place(file("both.tif"), {{600850, 7099400}, false, ""});
  std::string text;
  for (const auto& [key, value] : metres)
    if (key == "on the globe") text = value;
  Vec2 degrees;
  ASSERT_EQ(std::sscanf(text.c_str(), "longitude %lf, latitude %lf", &degrees.x, &degrees.y), 2) << text;
  const io::FileInfo back = describe_place(file("both.tif"), {degrees, true, ""});
  EXPECT_THAT(back, Contains(Pair("place", HasSubstr("x 6008"))));
}

}  // namespace
}  // namespace seamount::recipe
