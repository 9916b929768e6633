// The splat output of a terrain and of labels: files that an engine takes, of the height map's size.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "seamount/io/atomic_file.h"
#include "seamount/io/png_codec.h"
#include "seamount/io/raster.h"
#include "seamount/ops/terrain/layers.h"
#include "seamount/recipe/executor.h"

namespace seamount::recipe {
namespace {

constexpr const char* kFolder = "seamount_splat";

std::string folder() { return ::testing::TempDir() + kFolder; }

/// What a recipe with one output of the terrain reports.
ExecuteReport written(const HeightField& terrain, Json output) {
  std::filesystem::remove_all(folder());
  io::write_heights(terrain, folder() + "/in.tif");
  output["from"] = "t.terrain";
  output["path"] = "layers.png";
  output["as"] = "splat";
  const Json document = {{"seamount", 1},
                         {"steps", {{{"id", "t"}, {"op", "terrain.import"}, {"params", {{"file", "in.tif"}}}}}},
                         {"outputs", {output}}};
  return execute(parse_recipe(document.dump(), "splat.json", folder()), {folder(), ""}, {});
}

io::PngSamples picture(const std::string& name) {
  return io::decode_png_samples(io::read_file(folder() + "/" + name), name, 1 << 20);
}

HeightField ramp() {
  HeightField terrain(GridFrame::centred(40, 30, 25.0));
  for (size_t i = 0; i < terrain.size(); ++i) terrain.cells()[i] = static_cast<float>(i % 613) - 100.0F;
  return terrain;
}

TEST(SplatOfTerrain, IsItsLayersInGreyFilesThatSumToAll) {
  const HeightField terrain = ramp();
  written(terrain, {{"soft_m", 0}});
  const geom::Layers layers = terrain::layers(terrain, {}, {});
  const io::PngSamples low = picture("layers_low.png"), middle = picture("layers_middle.png"),
                       high = picture("layers_high.png"), seabed = picture("layers_seabed.png");
  ASSERT_EQ(low.channels, 1);
  for (size_t i = 0; i < terrain.size(); ++i) {
    ASSERT_EQ(low.bytes8[i] + middle.bytes8[i] + high.bytes8[i] + seabed.bytes8[i], 255);
    const float land = terrain.cells()[i] < 0 ? 0.0F : 255.0F;
    ASSERT_EQ(seabed.bytes8[i], land > 0 ? 0 : 255);
    ASSERT_NEAR(low.bytes8[i], land * layers.low.cells()[i], 1.0);
    ASSERT_NEAR(middle.bytes8[i], land * layers.middle.cells()[i], 1.0);
    ASSERT_NEAR(high.bytes8[i], land * layers.high.cells()[i], 1.0);
  }
  written(terrain, {{"soft_m", 0}, {"style", "stone"}, {"layers", {{"low_m", 0}, {"high_m", 20}}}});
  EXPECT_NE(picture("layers_low.png").bytes8, low.bytes8);
}

TEST(SplatOfTerrain, HasTheSizeOfTheHeightMapAndReportsItsFiles) {
  for (const auto& [members, width, height] : {std::tuple{Json{{"engine", "unreal"}, {"size", 127}}, 127, 127},
                                               {Json{{"engine", "unity"}}, 33, 33},
                                               {Json{{"size", 79}}, 79, 59},
                                               {Json{{"size", 79}, {"fit", "pad"}}, 79, 79},
                                               {Json::object(), 40, 30}}) {
    const ExecuteReport report = written(ramp(), members);
    ASSERT_EQ(report.outputs.size(), 1U);
    ASSERT_EQ(report.outputs[0].files.size(), 5U);
    for (const std::string& file : report.outputs[0].files) ASSERT_TRUE(std::filesystem::exists(file)) << file;
    EXPECT_EQ(picture("layers_low.png").width, width);
    EXPECT_EQ(picture("layers_low.png").height, height);
    const Json list = Json::parse(std::ifstream(folder() + "/layers_splat.json"));
    EXPECT_EQ(list["width"], width);
    for (const Json& layer : list["layers"]) {
      EXPECT_EQ(layer["file"], "layers_" + layer["name"].get<std::string>() + ".png");
      EXPECT_TRUE(layer.contains("percent_of_land"));
    }
  }
  EXPECT_THROW(written(ramp(), {{"engine", "unreal"}, {"size", 128}}), RecipeError);
  EXPECT_THROW(written(ramp(), {{"engine", "unity"}, {"fit", "whole"}}), RecipeError);
}

TEST(SplatOfLabels, HasAFileForEachRegionOfTheSizeAskedFor) {
  std::filesystem::remove_all(folder());
  const Json document = {
      {"seamount", 1},
      {"domain", {{"width_m", 6000}, {"height_m", 5000}, {"cell_m", 100}}},
      {"steps", {{{"id", "i"}, {"op", "island.build"}, {"params", {{"outlines", {2000}}, {"peak_m", 500}}}}}},
      {"outputs",
       {{{"from", "i.labels"}, {"path", "l.png"}, {"as", "splat"}, {"engine", "unreal"}, {"size", 127}},
        {{"from", "i.labels"}, {"path", "packed.png"}, {"as", "splat"}, {"files", "rgba"}}}}};
  const ExecuteReport report = execute(parse_recipe(document.dump(), "l.json", folder()), {folder(), ""}, {});
  ASSERT_EQ(report.outputs[0].files.size(), 6U);
  std::vector<int> sums(size_t{127} * 127, 0);
  bool soft = false;
  for (const char* name : {"mountain", "beach", "lagoon", "reef", "abyss"}) {
    const io::PngSamples weights = picture(std::string("l_") + name + ".png");
    ASSERT_EQ(weights.bytes8.size(), sums.size());
    for (size_t i = 0; i < sums.size(); ++i) {
      sums[i] += weights.bytes8[i];
      soft = soft || (weights.bytes8[i] > 100 && weights.bytes8[i] < 150);
    }
  }
  EXPECT_TRUE(soft);
  EXPECT_EQ(std::count(sums.begin(), sums.end(), 255), 127 * 127);
  EXPECT_EQ(picture("packed_0.png").bytes8[3], 255);
  EXPECT_EQ(picture("packed_1.png").bytes8[3], 255);
}

}  // namespace
}  // namespace seamount::recipe
