#include "seamount/tiles/windowed_outputs.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "seamount/io/test_files.h"
#include "seamount/tiles/run.h"
#include "seamount/tiles/test_world.h"

namespace seamount::tiles {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> files_in(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream file(entry.path(), std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    files[fs::relative(entry.path(), folder).string()] = text.str();
  }
  return files;
}

/// Every file of every format that is written by windows, for tiles of the run that fit the output's in no way.
TEST(WindowedOutputs, HaveTheBytesOfTheWholeRun) {
  const io::TestFolder folder;
  const recipe::Recipe recipe = small_world(R"([
    {"from": "hills", "path": "unreal/a.r16", "as": "tiles", "engine": "unreal", "tile_size": 127},
    {"from": "hills", "path": "unity/a.raw", "as": "tiles", "engine": "unity", "tile_size": 129},
    {"from": "hills", "path": "godot/a.exr", "as": "tiles", "engine": "godot", "tile_size": 256},
    {"from": "steep.mask", "path": "unreal/steep.png", "as": "tiles", "engine": "unreal", "tile_size": 127},
    {"from": "hills", "path": "gis/a.tif", "as": "tiles", "tile_size": 200},
    {"from": "steep.mask", "path": "gis/steep.npy", "as": "tiles", "tile_size": 200, "share_border": false},
    {"from": "hills", "path": "mesh/a.glb", "as": "mesh_tiles", "tile_size": 129, "lods": 2, "max_error_m": 8, "texture_px": 128},
    {"from": "hills", "path": "mesh/b.obj", "as": "mesh_tiles", "tile_size": 257, "max_error_m": 8, "texture_px": 0}])");
  recipe::execute(recipe, {folder("whole"), ""}, {});
  const auto whole = files_in(folder("whole"));
  EXPECT_GT(whole.size(), 60U);
  EXPECT_TRUE(whole.contains("mesh/a.gltf"));
  for (const int tile : {100, 333}) {
    const std::string out = folder(std::to_string(tile));
    execute(recipe, {out, folder("cache" + std::to_string(tile)), tile, 0}, {});
    const auto files = files_in(out);
    EXPECT_EQ(files.size(), whole.size());
    for (const auto& [name, bytes] : whole) {
      const auto found = files.find(name);
      ASSERT_NE(found, files.end()) << name;
      EXPECT_TRUE(found->second == bytes) << name << ", tiles of " << tile;
    }
  }
}

/// Nothing but a tile and its surroundings may be in memory at once.
TEST(WindowedOutputs, NeedNoWhole) {
  const io::TestFolder folder;
  const recipe::Recipe recipe = small_world(R"([
    {"from": "hills", "path": "a.r16", "as": "tiles", "engine": "unreal", "tile_size": 127},
    {"from": "hills", "path": "b.glb", "as": "mesh_tiles", "tile_size": 129, "texture_px": 0}])");
  EXPECT_NO_THROW(execute(recipe, {folder("out"), folder("cache"), 100, 200000}, {}));
  const recipe::Recipe png = small_world(R"([{"from": "hills", "path": "a.png"}])");
  EXPECT_THROW(execute(png, {folder("out"), folder("cache"), 100, 200000}, {}), Error) << "so little that it tells";
}

/// Cells without a value are filled as in the whole run, where that fits.
TEST(WindowedOutputs, FillWhatHasNoValueAsTheWholeRunDoes) {
  const io::TestFolder folder;
  recipe::Recipe first = recipe::parse_recipe(R"({"seamount": 1,
    "domain": {"width_m": 3000, "height_m": 3000, "cell_m": 20}, "steps": [{"id": "a", "op": "terrain.noise"}],
    "outputs": [{"from": "a", "path": "small.tif"}]})",
                                              "a.json", "");
  recipe::execute(first, {folder("in"), ""}, {});
  const std::string text = R"({"seamount": 1, "domain": {"width_m": 4000, "height_m": 3600, "cell_m": 20},
    "steps": [{"id": "read", "op": "terrain.import", "params": {"file": ")" +
                           folder("in/small.tif") + R"("}}, {"id": "on", "op": "terrain.resample"}],
    "outputs": [{"from": "on", "path": "a.r16", "as": "tiles", "engine": "unreal", "tile_size": 127}]})";
  const recipe::Recipe recipe = recipe::parse_recipe(text, "b.json", "");
  recipe::execute(recipe, {folder("whole"), ""}, {});
  execute(recipe, {folder("tiled"), folder("cache"), 64, 0}, {});
  EXPECT_TRUE(files_in(folder("whole")) == files_in(folder("tiled")));
}

}  // namespace
}  // namespace seamount::tiles
