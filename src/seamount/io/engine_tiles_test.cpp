#include "seamount/io/engine_tiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "seamount/io/png_codec.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using ::testing::HasSubstr;

/// Hills with a ridge 200 m high along a row, over the borders between columns of tiles, and one down a column.
HeightField ridges(const GridFrame& frame, int row, int column) {
  HeightField heights = test_terrain(frame);
  for (int x = 0; x < frame.width; ++x) heights(x, row) += 200.0F;
  for (int y = 0; y < frame.height; ++y) heights(column, y) += 200.0F;
  return heights;
}

std::vector<uint16_t> codes_of(const std::string& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  std::vector<uint16_t> codes(bytes.size() / 2);
  std::memcpy(codes.data(), bytes.data(), bytes.size());
  return codes;
}

nlohmann::json json_of(const std::string& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  return nlohmann::json::parse(bytes.begin(), bytes.end());
}

double number(const nlohmann::json& json) { return std::stod(json.get<std::string>()); }

TEST(EngineTiles, OfUnrealShareTheirBordersAndOneScale) {
  const TestFolder folder;
  const GridFrame frame{300, 260, 12.5, 0, 0, ""};
  const HeightField heights = ridges(frame, 126, 126);  // on the borders themselves
  const TileOptions options{.tile_size = 127, .engine = Engine::unreal};
  const auto tiles = write_tiles(heights, folder("world.r16"), options);
  ASSERT_EQ(tiles.size(), 9U);
  EXPECT_EQ(std::filesystem::path(tiles[5].path).filename(), "world_x2_y1.r16");
  const auto code = [&](size_t tile, int x, int y) {
    return codes_of(tiles[tile].path)[static_cast<size_t>(127 * y + x)];
  };
  for (int y = 0; y < 127; ++y) {
    EXPECT_EQ(code(0, 126, y), code(1, 0, y));
    EXPECT_EQ(code(4, y, 126), code(7, y, 0));
  }
  const auto list = json_of(folder("world_tiles.json"));
  const double scale = number(list["numbers"]["Scale Z"]), location = number(list["numbers"]["Location Z"]);
  EXPECT_EQ(number(list["numbers"]["Scale X"]), 1250);
  for (const auto& tile : list["tiles"]) {  // heights by the numbers alone, as Unreal makes them
    const auto codes = codes_of(folder(tile["file"]));
    for (const int i : {0, 100, 126 * 127, 127 * 127 - 1}) {
      const double z = (location + (codes[static_cast<size_t>(i)] - 32768.0) / 128.0 * scale) / 100.0;
      const int x = tile["column"].get<int>() + i % 127, y = tile["row"].get<int>() + i / 127;
      EXPECT_NEAR(z, heights.clamped(x, y), 0.51 * scale / 12800.0);
    }
  }
  // A tile's first sample lies where the whole's does when its middle is the origin.
  EXPECT_NEAR(number(list["tiles"][5]["place"]["Location X"]), 100 * 12.5 * (252 - 149.5), 0.01);
  EXPECT_NEAR(number(list["tiles"][5]["place"]["Location Y"]), 100 * 12.5 * (126 - 129.5), 0.01);
}

TEST(EngineTiles, ForWorldPartitionLieSideBySideAndGiveTheWholeBack) {
  const TestFolder folder;
  const HeightField heights = ridges({90, 60, 2, 0, 0, ""}, 30, 29);
  const auto tiles =
      write_tiles(heights, folder("land.png"), {.tile_size = 30, .share_border = false, .engine = Engine::unreal});
  ASSERT_EQ(tiles.size(), 6U);
  const HeightRange range = *read_sidecar(tiles[0].path)->range;
  for (const Tile& tile : tiles) {
    const HeightField part = read_heights(tile.path);
    for (int y = 0; y < 30; ++y)
      for (int x = 0; x < 30; ++x)
        ASSERT_NEAR(part(x, y), heights(tile.column + x, tile.row + y), 0.51 * (range.high_m - range.low_m) / 65535);
  }
}

TEST(EngineTiles, OfUnityCountFromTheSouthAndHaveTheirSouthernRowFirst) {
  const TestFolder folder;
  const HeightField heights = ridges({65, 97, 10, 0, 0, ""}, 32, 40);
  const auto tiles =
      write_tiles(heights, folder("land.raw"), {.tile_size = 33, .engine = Engine::unity}, {.range = {{-2000, 2000}}});
  ASSERT_EQ(tiles.size(), 6U);
  const auto list = json_of(folder("land_tiles.json"));
  EXPECT_EQ(list["first_row"], "south");
  EXPECT_EQ(number(list["numbers"]["Terrain Height"]), 4000);
  EXPECT_EQ(number(list["numbers"]["Terrain Width"]), 320);
  for (const auto& tile : list["tiles"]) {
    EXPECT_EQ(tile["file"],
              "land_" + std::to_string(tile["x"].get<int>()) + "_" + std::to_string(2 - tile["y"].get<int>()) + ".raw");
    const auto codes = codes_of(folder(tile["file"]));
    EXPECT_EQ(number(tile["place"]["Position X"]), 320 * tile["x"].get<int>());
    EXPECT_EQ(number(tile["place"]["Position Z"]), 320 * (2 - tile["y"].get<int>()));
    for (const int row : {0, 7, 32}) {
      const double z = -2000 + codes[static_cast<size_t>(33 * row + 5)] / 65535.0 * 4000;
      EXPECT_NEAR(z, heights(tile["column"].get<int>() + 5, tile["row"].get<int>() + 32 - row), 0.04);
    }
  }
  const auto north = codes_of(folder("land_0_1.raw")), south = codes_of(folder("land_0_0.raw"));
  for (size_t x = 0; x < 33; ++x) EXPECT_EQ(north[x], south[33 * 32 + x]);
}

TEST(EngineTiles, OfGodotAreRegionsAroundTheOrigin) {
  const TestFolder folder;
  const HeightField heights = ridges({200, 130, 4, 0, 0, ""}, 64, 63);
  const auto tiles =
      write_tiles(heights, folder("land.exr"), {.tile_size = 64, .share_border = false, .engine = Engine::godot});
  ASSERT_EQ(tiles.size(), 12U);
  for (const Tile& tile : tiles) {
    const HeightField part = read_heights(tile.path);
    EXPECT_EQ(part(0, 0), heights(tile.column, tile.row));
    EXPECT_EQ(part(63, 63), heights.clamped(tile.column + 63, tile.row + 63));
  }
  const auto list = json_of(folder("land_tiles.json"));
  EXPECT_EQ(list["tiles"][0]["place"]["region"], "-2, -1");
  EXPECT_EQ(number(list["tiles"][0]["place"]["Position X"]), -2 * 64 * 4);
  EXPECT_EQ(list["numbers"]["vertex spacing"], "4");
}

TEST(EngineTiles, OfAMaskAreGreyPicturesAndOfOtherFieldsAreRefused) {
  const TestFolder folder;
  Grid<float> mask(GridFrame{100, 66, 1, 0, 0, ""});
  for (int y = 0; y < 66; ++y)
    for (int x = 0; x < 100; ++x) mask(x, y) = static_cast<float>(x) / 99.0F;
  const TileOptions options{.tile_size = 33, .engine = Engine::unity};
  const auto tiles = write_tiles(windows_of(mask, false), folder("sand.png"), options);
  EXPECT_EQ(std::filesystem::path(tiles[0].path).filename(), "sand_0_2.png");
  const PlacedImage picture = read_placed_image(tiles[1].path);
  EXPECT_EQ(picture.image.width, 33);
  EXPECT_EQ(picture.image.colour(0, 0).r, std::lround(32 / 99.0 * 255));
  mask(50, 50) = 3.0F;
  EXPECT_THAT(error_of([&] { write_tiles(windows_of(mask, false), folder("no.png"), options); }),
              HasSubstr("are no mask from 0 to 1"));
  EXPECT_THAT(error_of([&] { write_tiles(windows_of(mask, false), folder("no.raw"), options); }),
              HasSubstr(".png of 8 bits"));
}

TEST(EngineTiles, WhatAnEngineDoesNotReadIsRefusedBeforeAFileIsWritten) {
  const TestFolder folder;
  const HeightField heights = test_terrain({40, 40, 1, 0, 0, ""});
  const auto refused = [&](const std::string& name, const TileOptions& options) {
    return error_of([&] { write_tiles(heights, folder(name), options); });
  };
  EXPECT_THAT(refused("a.r16", {.tile_size = 128, .engine = Engine::unreal}), HasSubstr("127, 253, 505"));
  EXPECT_THAT(refused("a.raw", {.tile_size = 128, .engine = Engine::unity}), HasSubstr("33, 65, 129"));
  EXPECT_THAT(refused("a.exr", {.tile_size = 100, .share_border = false, .engine = Engine::godot}),
              HasSubstr("64, 128, 256"));
  EXPECT_THAT(refused("a.exr", {.tile_size = 64, .engine = Engine::godot}), HasSubstr("share no samples"));
  EXPECT_THAT(refused("a.raw", {.tile_size = 33, .share_border = false, .engine = Engine::unity}), HasSubstr("gaps"));
  EXPECT_THAT(refused("a.tif", {.tile_size = 127, .engine = Engine::unreal}), HasSubstr("not a format"));
  EXPECT_THAT(refused("a.r16", {.tile_size = 127, .last_tiles = LastTiles::smaller, .engine = Engine::unreal}),
              HasSubstr("one size only"));
  EXPECT_THAT(refused("a.exr", {.engine = Engine::blender}), HasSubstr("no tiles"));
  EXPECT_EQ(folder.files(), 0U);
}

TEST(EngineTiles, NamesThatUnrealWouldMisreadAreSaid) {
  EXPECT_TRUE(confuses_unreal("maps/island_v2.r16"));
  EXPECT_TRUE(confuses_unreal("x-1.r16"));
  EXPECT_FALSE(confuses_unreal("v2/island.r16"));
  EXPECT_FALSE(confuses_unreal("island_2_vary.r16"));
}

}  // namespace
}  // namespace seamount::io
