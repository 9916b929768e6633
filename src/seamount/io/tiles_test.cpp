#include "seamount/io/tiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "seamount/io/info.h"
#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

struct Case {
  int width, height;
  TileOptions options;
  std::string extension;
};

Case random_case(uint64_t seed) {
  Rng rng(Seed{seed}.derive("tiles"));
  const std::vector<std::string> extensions = {".tif", ".npy", ".r32", ".exr", ".asc"};
  return {1 + rng.integer(0, 149),
          1 + rng.integer(0, 109),
          {.tile_size = 16 + rng.integer(0, 45),
           .last_tiles = static_cast<LastTiles>(rng.integer(0, 2)),
           .share_border = rng.chance(0.6)},
          extensions[static_cast<size_t>(rng.integer(0, 4))]};
}

/// In how many tiles sample i of n belongs, by counting: tile k begins at k times the stride.
int belongs_to(int i, int n, int tile_size, bool share_border) {
  const int stride = share_border ? tile_size - 1 : tile_size;
  int count = 0;
  for (int begin = 0; begin < n; begin += stride) {
    const bool nothing_new = begin > 0 && share_border && begin == n - 1;  // its one sample is the border before
    if (!nothing_new && i >= begin && i < begin + tile_size) ++count;
  }
  return count;
}

TEST(Tiles, OfFiftySizesCoverTheTerrainExactly) {
  for (uint64_t seed = 0; seed < 50; ++seed) {
    const TestFolder folder;
    const Case c = random_case(seed);
    const HeightField heights = test_terrain({c.width, c.height, 2.5, 100, 200, "EPSG:32604"}, seed + 1);
    SCOPED_TRACE(std::to_string(c.width) + " x " + std::to_string(c.height) + " in " +
                 std::to_string(c.options.tile_size) + c.extension);
    const std::vector<Tile> tiles = write_tiles(heights, folder("t" + c.extension), c.options);
    const bool gis = c.extension == ".tif" || c.extension == ".asc";
    const bool padded =
        c.options.last_tiles == LastTiles::padded || (c.options.last_tiles == LastTiles::by_format && !gis);
    Grid<int> seen(heights.frame(), 0);
    for (const Tile& tile : tiles) {
      const HeightField part = read_heights(tile.path);
      EXPECT_EQ(part.width(), padded ? c.options.tile_size : tile.width);
      EXPECT_EQ(part.height(), padded ? c.options.tile_size : tile.height);
      EXPECT_EQ(part.frame().cell_m, 2.5);
      EXPECT_EQ(part.frame().x(0), heights.frame().x(tile.column));
      EXPECT_EQ(part.frame().y(0), heights.frame().y(tile.row));
      for (int y = 0; y < part.height(); ++y) {
        for (int x = 0; x < part.width(); ++x) {
          ASSERT_EQ(part(x, y), heights.clamped(tile.column + x, tile.row + y)) << x << " " << y;
          if (heights.contains(tile.column + x, tile.row + y)) ++seen(tile.column + x, tile.row + y);
        }
      }
    }
    for (int y = 0; y < c.height; ++y) {
      for (int x = 0; x < c.width; ++x) {
        ASSERT_EQ(seen(x, y), belongs_to(x, c.width, c.options.tile_size, c.options.share_border) *
                                  belongs_to(y, c.height, c.options.tile_size, c.options.share_border))
            << x << " " << y;
      }
    }
  }
}

TEST(Tiles, OfSixteenBitsShareOneRange) {
  const TestFolder folder;
  const HeightField heights = test_terrain({70, 45, 2, 100, 200, "EPSG:32604"});
  for (const std::string extension : {".r16", ".png"}) {
    write_heights(heights, folder("whole" + extension));
    const HeightField whole = read_heights(folder("whole" + extension));
    for (const Tile& tile : write_tiles(heights, folder("t" + extension), {.tile_size = 17})) {
      const HeightField part = read_heights(tile.path);
      for (int y = 0; y < 17; ++y)
        for (int x = 0; x < 17; ++x) ASSERT_EQ(part(x, y), whole.clamped(tile.column + x, tile.row + y));
    }
  }
}

TEST(Tiles, AreListedWithTheirSamplesAndWhatWasPaddedIsSaid) {
  const TestFolder folder;
  const HeightField heights = test_terrain({40, 33, 10, 1000, 2000, ""});
  std::vector<std::string> said;
  RunContext run;
  run.note = [&](const std::string& line) { said.push_back(line); };
  const auto tiles = write_tiles(heights, folder("t.r16"), {.tile_size = 17}, {.range = HeightRange{-4000, 4000}}, run);
  const auto bytes = read_file(folder("t_tiles.json"));
  const auto list = nlohmann::json::parse(bytes.begin(), bytes.end());
  EXPECT_EQ(list["columns"], 3);
  EXPECT_EQ(list["rows"], 2);
  EXPECT_EQ(list["east_m"], 1400);
  EXPECT_EQ(list["high_m"], 4000);
  ASSERT_EQ(list["tiles"].size(), tiles.size());
  EXPECT_EQ(list["tiles"][5]["file"], "t_x2_y1.r16");
  EXPECT_EQ(list["tiles"][5]["column"], 32);
  EXPECT_EQ(list["tiles"][5]["width"], 8);
  EXPECT_EQ(list["tiles"][5]["height"], 17);
  EXPECT_THAT(said,
              ElementsAre("3 x 2 tiles cover x 1000 to 1400 m and y 1670 to 2000 m; t_tiles.json lists them",
                          "the last tiles in the east have 8 columns of ground and those in the south 17 rows, of "
                          "17; the rest of them repeats the terrain's edge"));
  EXPECT_THAT(*describe_raster(tiles[5].path), Contains(Pair("ground", "8 x 17 samples; the others repeat its edge")));
  EXPECT_EQ(read_sidecar(tiles[4].path)->ground_width, 0) << "a whole tile";
}

TEST(Tiles, RefuseNonsense) {
  const TestFolder folder;
  EXPECT_THAT(error_of([&] {
                write_tiles(test_terrain({9, 9, 1, 0, 0, ""}), folder("t.tif"), {.tile_size = 1});
              }),
              HasSubstr("is below 2"));
  EXPECT_EQ(folder.files(), 0U);
}

}  // namespace
}  // namespace seamount::io
