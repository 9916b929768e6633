#include "seamount/io/info.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "seamount/io/engine.h"
#include "seamount/io/image_file.h"
#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"
#include "seamount/io/vector.h"

namespace seamount::io {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Key;
using ::testing::Not;
using ::testing::Pair;

TEST(DescribeFile, TellsWhatToTypeIn) {
  const TestFolder folder;
  const HeightField heights = test_terrain(GridFrame::centred(127, 127, 12.5));
  const EngineOptions options{.provenance = {"Seamount 9", "isle.json", 42}};
  write_for_engine(heights, Engine::unreal, folder("land.r16"), options);
  const FileInfo info = *describe_raster(folder("land.r16"));
  EXPECT_THAT(info, Contains(Pair("size", "127 x 127")));
  EXPECT_THAT(info, Contains(Pair("cell", "12.5 m")));
  EXPECT_THAT(info, Contains(Pair("made for", "unreal")));
  EXPECT_THAT(info, Contains(Pair("  Scale X", "1250")));
  EXPECT_THAT(info, Contains(Key("  Scale Z")));
  EXPECT_THAT(info, Contains(Pair("recipe", "isle.json")));
  EXPECT_THAT(info, Contains(Pair("seed", "42")));
}

TEST(DescribeFile, KnowsGisFiles) {
  const TestFolder folder;
  write_heights(test_terrain({20, 10, 30, 400000, 2400000, "EPSG:32604"}), folder("height.tif"));
  const FileInfo info = *describe_raster(folder("height.tif"));
  EXPECT_THAT(info, Contains(Pair("format", "GeoTIFF, float32")));
  EXPECT_THAT(info, Contains(Pair("extent", "600 m x 300 m")));
  EXPECT_THAT(info, Contains(Pair("coordinate system", "WGS 84 / UTM zone 4N")));
  EXPECT_THAT(info, Not(Contains(Key("cells without value"))));
  write_drawing({{{"kauai", {{{{0, 0}, {1, 0}, {0, 1}}, {}}}}}, {}, "EPSG:32604"}, folder("x.gpkg"));
  EXPECT_THAT(*describe_vector(folder("x.gpkg")), Contains(Pair("features", "kauai")));
}

TEST(DescribeFile, TellsTheShareOfEachRegion) {
  const TestFolder folder;
  LabelMap labels({20, 10, 30, 400000, 2400000, "EPSG:32604"}, Region::abyss);
  for (int x = 0; x < 15; ++x) labels(x, 0) = Region::mountain;
  for (int x = 0; x < 9; ++x) labels(x, 4) = Region::lagoon;
  write_labels(labels, folder("labels.tif"));
  write_labels(labels, folder("labels.png"));
  for (const FileInfo& info : {*describe_raster(folder("labels.tif")), *describe_picture(folder("labels.png"))}) {
    EXPECT_THAT(info, Contains(Pair("size", "20 x 10")));
    EXPECT_THAT(info, Contains(Pair("cell", "30 m")));
    EXPECT_THAT(info, Contains(Pair("coordinate system", "WGS 84 / UTM zone 4N")));
    EXPECT_THAT(info, Contains(Pair("mountain", "7.5 %")));
    EXPECT_THAT(info, Contains(Pair("beach", "0 %")));
    EXPECT_THAT(info, Contains(Pair("lagoon", "4.5 %")));
    EXPECT_THAT(info, Contains(Pair("abyss", "88 %")));
    EXPECT_THAT(info, Not(Contains(Key("no region"))));
  }
  Image picture(10, 10, painted_colour(Region::reef, 0.5));
  picture.pixel(0, 0)[0] = 17;
  write_png(picture, folder("painted.png"));
  EXPECT_THAT(*describe_picture(folder("painted.png")), Contains(Pair("no region", "1 %")));
  EXPECT_THAT(*describe_picture(folder("painted.png")), Contains(Pair("reef", "99 %")));
  picture.pixel(1, 0)[0] = 17;
  write_png(picture, folder("photo.png"));
  EXPECT_THAT(*describe_picture(folder("photo.png")), Not(Contains(Key("reef"))));
}

TEST(DescribeFile, SaysNothingOfOtherFiles) {
  const TestFolder folder;
  EXPECT_FALSE(describe_raster(folder("x.doc")));
  EXPECT_FALSE(describe_picture(folder("x.doc")));
  EXPECT_FALSE(describe_vector(folder("x.doc")));
  EXPECT_THAT(error_of([&] { describe_raster(folder("missing.tif")); }), HasSubstr("no such file"));
}

}  // namespace
}  // namespace seamount::io
