// Bundles: height map, layers and texture of one engine in a folder, all of the same ground.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "seamount/io/atomic_file.h"
#include "seamount/io/image_file.h"
#include "seamount/io/png_codec.h"
#include "seamount/io/raster.h"
#include "seamount/io/texture_part.h"
#include "seamount/recipe/executor.h"

namespace seamount::recipe {
namespace {

namespace fs = std::filesystem;

std::string folder() { return ::testing::TempDir() + "seamount_bundle"; }

ExecuteReport written(const HeightField& terrain, Json output) {
  fs::remove_all(folder());
  io::write_heights(terrain, folder() + "/in.tif");
  output.update({{"from", "t.terrain"}, {"path", "isle"}, {"as", "bundle"}});
  const Json document = {{"seamount", 1},
                         {"steps", {{{"id", "t"}, {"op", "terrain.import"}, {"params", {{"file", "in.tif"}}}}}},
                         {"outputs", {output}}};
  return execute(parse_recipe(document.dump(), "bundle.json", folder()), {folder(), ""}, {});
}

HeightField isle(int width, int height) {
  HeightField terrain(GridFrame::centred(width, height, 20.0));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      terrain(x, y) = static_cast<float>(400 - std::hypot(terrain.frame().x(x), 1.3 * terrain.frame().y(y)));
  return terrain;
}

TEST(Bundle, HasAllFilesOfOneSizeForEveryEngine) {
  struct Case {
    const char *engine, *height;
    int size, columns, rows;
  };
  for (const Case& is : {Case{"unreal", "height.r16", 127, 127, 127}, Case{"unity", "height.raw", 65, 65, 65},
                         Case{"godot", "height.exr", 0, 80, 60}, Case{"blender", "height.exr", 40, 40, 31}}) {
    const ExecuteReport report = written(isle(80, 60), {{"engine", is.engine}, {"size", is.size}, {"texture_px", 64}});
    ASSERT_EQ(report.outputs.size(), 1U);
    EXPECT_EQ(report.outputs[0].files.size(), 10U);
    for (const std::string& file : report.outputs[0].files) EXPECT_TRUE(fs::exists(file)) << file;
    const std::string in = folder() + "/isle/";
    const Json json = Json::parse(std::ifstream(in + "import.json"));
    EXPECT_EQ(json["engine"], is.engine);
    EXPECT_EQ(json["height"]["file"], is.height);
    EXPECT_EQ(json["height"]["width"], is.columns);
    EXPECT_EQ(json["height"]["height"], is.rows);
    EXPECT_FALSE(json["height"]["numbers"].empty());
    ASSERT_EQ(json["layers"].size(), 4U);
    std::vector<int> sums(static_cast<size_t>(is.columns) * static_cast<size_t>(is.rows), 0);
    for (const Json& layer : json["layers"]) {
      const std::string file = in + layer["file"].get<std::string>();
      const io::PngSamples picture = io::decode_png_samples(io::read_file(file), file, 1 << 20);
      ASSERT_EQ(picture.bytes8.size(), sums.size()) << is.engine;
      EXPECT_EQ(picture.width, is.columns);
      for (size_t i = 0; i < sums.size(); ++i) sums[i] += picture.bytes8[i];
    }
    for (const int sum : sums) ASSERT_EQ(sum, 255);
    const HeightField back = io::read_heights(in + is.height);
    EXPECT_EQ(back.width(), is.columns);
    EXPECT_EQ(io::read_image(in + "texture.png").width, json["texture"]["width"]);
    const std::vector<uint8_t> bytes = io::read_file(in + "import.txt");
    const std::string text(bytes.begin(), bytes.end());
    for (const auto& [place, value] : json["height"]["numbers"].items()) {
      EXPECT_NE(text.find(place), std::string::npos) << place;
      EXPECT_NE(text.find(value.get<std::string>()), std::string::npos) << value;
    }
  }
}

TEST(Bundle, LeavesTheTextureOutAndRefusesWhatTheEngineDoes) {
  const ExecuteReport report = written(isle(70, 70), {{"engine", "unity"}, {"texture_px", 0}});
  EXPECT_EQ(report.outputs[0].files.size(), 9U);
  EXPECT_FALSE(fs::exists(folder() + "/isle/texture.png"));
  EXPECT_THROW(written(isle(70, 70), {{"engine", "unity"}, {"size", 128}}), RecipeError);
  EXPECT_THROW(written(isle(70, 70), {{"engine", "unreal"}, {"fit", "whole"}}), RecipeError);
  EXPECT_ANY_THROW(written(isle(70, 70), {{"low_m", 0}, {"high_m", 10}, {"texture_px", 0}}));
  EXPECT_FALSE(fs::exists(folder() + "/isle")) << "all files or none";
}

TEST(TexturePart, LiesOverTheSamplesAsTheGroundDoes) {
  const GridFrame whole = GridFrame::centred(80, 40, 10.0);
  Image picture(160, 80);
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 160; ++x)
      picture.pixel(x, y)[0] = static_cast<uint8_t>(x), picture.pixel(x, y)[1] = static_cast<uint8_t>(2 * y);
  EXPECT_EQ(io::texture_over(picture, whole, whole), picture);
  GridFrame part = whole;
  part.width = 30, part.height = 20, part.west_m += 100, part.north_m -= 50;
  const Image over = io::texture_over(picture, whole, part);
  ASSERT_EQ(over.width, 60);
  ASSERT_EQ(over.height, 40);
  EXPECT_EQ(over.pixel(0, 0)[0], 20);
  EXPECT_EQ(over.pixel(59, 39)[0], 79);
  EXPECT_EQ(over.pixel(0, 39)[1], 2 * 49);
  const Image between = io::texture_between(picture, whole, part);
  EXPECT_EQ(between.width, 58);
  EXPECT_EQ(between.height, 38);
  EXPECT_EQ(between.pixel(0, 0)[0], 21);
  EXPECT_EQ(between.pixel(0, 37)[1], 2 * 48);
}

}  // namespace
}  // namespace seamount::recipe
