#include "seamount/tiles/run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"
#include "seamount/recipe/kinds.h"
#include "seamount/tiles/stored_raster.h"
#include "seamount/tiles/test_world.h"
#include "seamount/tiles/windows.h"

namespace seamount::tiles {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// Local chains around a step that looks at everything, on cells of no round size; several outputs of one chain.
const char* const kWorld = R"({"seamount": 1, "seed": 9,
  "domain": {"width_m": 31000, "height_m": 26500, "cell_m": 31.07},
  "steps": [
    {"id": "hills", "op": "terrain.noise", "params": {"wavelength_m": 5000, "base_m": -120}},
    {"id": "ridges", "op": "terrain.noise", "params": {"kind": "ridged", "wavelength_m": 2600, "height_m": 300}},
    {"id": "steep", "op": "terrain.mask", "in": "hills", "params": {"criteria": [{"tool": "slope", "low_deg": 14, "scale_m": 150}]}},
    {"id": "both", "op": "terrain.blend", "in": {"terrain": "hills", "with": "ridges", "mask": "steep"}, "params": {"mode": "add", "strength": 0.4}},
    {"id": "filled", "op": "hydrology.fill", "in": {"terrain": "both"}},
    {"id": "soft", "op": "terrain.smooth", "in": {"terrain": "filled.terrain", "mask": "steep"}, "params": {"radius_m": 90}},
    {"id": "isle", "op": "classify.terrain", "in": {"terrain": "soft"}},
    {"id": "shore", "op": "terrain.mask", "in": {"terrain": "soft", "labels": "isle.labels"},
     "params": {"criteria": [{"tool": "region", "region": "beach", "high_m": 200}]}}],
  "outputs": [
    {"from": "soft.terrain", "path": "height.tif"}, {"from": "shore.mask", "path": "shore.tif"},
    {"from": "isle.labels", "path": "labels.tif"}, {"from": "steep.mask", "path": "steep.npy"}]})";

recipe::Recipe parse(const std::string& text) { return recipe::parse_recipe(text, "world.json", ""); }

/// Every output's cells as they are read back.
std::map<std::string, std::vector<float>> cells_of_outputs(const std::string& folder) {
  std::map<std::string, std::vector<float>> all;
  for (const char* name : {"height.tif", "shore.tif", "labels.tif", "steep.npy"}) {
    const ScalarField field = io::read_field(folder + "/" + name, {.cell_m = 31.07});
    all[name].assign(field.cells().begin(), field.cells().end());
  }
  return all;
}

TEST(TiledRun, HasTheBytesOfTheWholeForAnySizeOfTiles) {
  const io::TestFolder folder;
  const recipe::Recipe recipe = parse(kWorld);
  recipe::execute(recipe, {folder("whole"), ""}, {});
  const auto whole = cells_of_outputs(folder("whole"));
  std::map<std::string, std::string> files;
  for (const int tile : {100, 333, 997, 5000}) {
    const std::string out = folder(std::to_string(tile));
    execute(recipe, {out, folder("cache" + std::to_string(tile)), tile, 0}, {});
    const auto cells = cells_of_outputs(out);
    for (const auto& [name, values] : whole) {
      const auto& found = cells.at(name);
      ASSERT_EQ(found.size(), values.size()) << name;
      EXPECT_EQ(std::memcmp(found.data(), values.data(), values.size() * sizeof(float)), 0) << name << ", " << tile;
      const std::string bytes = bytes_of(out + "/" + name);
      EXPECT_TRUE(files.emplace(name, bytes).first->second == bytes) << "the file " << name << ", tiles of " << tile;
    }
    EXPECT_TRUE(fs::is_empty(folder("cache" + std::to_string(tile)) + "/tiles")) << "what is done leaves no tiles";
  }
}

/// A run that stops halfway leaves its tiles, and the next one makes only the others.
TEST(TiledRun, GoesOnWhereARunWasStopped) {
  const io::TestFolder folder;
  const recipe::Recipe recipe = parse(R"({"seamount": 1, "domain": {"width_m": 8000, "height_m": 8000, "cell_m": 20},
    "steps": [{"id": "hills", "op": "terrain.noise", "params": {"kind": "smooth"}}],
    "outputs": [{"from": "hills", "path": "a.tif"}]})");
  const TileOptions options{folder("out"), folder("cache"), 100, 0};
  std::atomic<bool> stop{false};
  EXPECT_THROW(
      execute(recipe, options, {.threads = 1, .progress = [&](double f) { stop = f > 0.4; }, .cancelled = &stop}),
      Cancelled);
  std::vector<fs::path> left;
  for (const auto& entry : fs::recursive_directory_iterator(folder("cache/tiles")))
    if (entry.path().extension() == ".tile") left.push_back(entry.path());
  ASSERT_GT(left.size(), 4U);
  ASSERT_LT(left.size(), 16U);
  EXPECT_FALSE(fs::exists(folder("out")));
  // Another's noise in one of the tiles that are left: it is taken as it is, for nothing is made twice.
  const StoredRaster raster(left[0].parent_path().string(), *recipe.steps[0].op->out[0].kind, recipe.domain, 100);
  raster.write(0, recipe::Value::of<recipe::kinds::Terrain>(HeightField(GridFrame{100, 100, 20.0}, 77.0F)));
  execute(recipe, options, {});
  const HeightField made = io::read_heights(folder("out/a.tif"));
  EXPECT_EQ(made(5, 5), 77.0F);
  EXPECT_NE(made(105, 5), 77.0F);
}

TEST(TiledRun, ADamagedTileIsMadeAnew) {
  const io::TestFolder folder;
  const GridFrame frame{300, 200, 10.0};
  const StoredRaster raster(folder("tiles"), recipe::kinds::Terrain::kind(), frame, 128);
  HeightField whole(frame);
  for (size_t i = 0; i < whole.size(); ++i) whole.data()[i] = static_cast<float>(i);
  const recipe::Value value = recipe::Value::of<recipe::kinds::Terrain>(whole);
  for (int tile = 0; tile < raster.layout().count(); ++tile) {
    EXPECT_FALSE(raster.has(tile));
    raster.write(tile, window_of(value, raster.layout().tile(tile)));
  }
  EXPECT_TRUE(raster.complete());
  const Rect rect{100, 60, 170, 120};
  const recipe::Value read = raster.read(rect);
  EXPECT_EQ(read.get<recipe::kinds::Terrain>(), window_of(value, rect).get<recipe::kinds::Terrain>());
  EXPECT_EQ(raster.read({0, 0, 300, 200}).get<recipe::kinds::Terrain>().cells().size(), whole.size());
  const std::string file = folder("tiles/0_1.tile");
  {
    std::fstream damage(file, std::ios::binary | std::ios::in | std::ios::out);
    damage.seekp(3000);
    damage.put('x');
  }
  EXPECT_TRUE(raster.has(1)) << "its length says nothing";
  EXPECT_THROW(raster.read(rect), IoError);
  EXPECT_FALSE(raster.has(1));
  fs::resize_file(folder("tiles/0_0.tile"), 1000);
  EXPECT_FALSE(raster.has(0));
}

std::string message_of(const std::string& recipe, TileOptions options) {
  try {
    execute(parse(recipe), options, {});
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// A picture's ground of a world that does not fit: means over larger cells, unknown ones too.
TEST(TiledRun, LargerCellsOfWhatDoesNotFit) {
  const io::TestFolder folder;
  const std::string text = R"({"seamount": 1, "domain": {"width_m": 12345, "height_m": 9876, "cell_m": 19.7},
    "steps": [{"id": "hills", "op": "terrain.noise", "params": {"kind": "smooth"}},
              {"id": "coarse", "op": "terrain.resample", "params": {"cell_m": 83}}],
    "outputs": [{"from": "coarse", "path": "coarse.npy"}]})";
  recipe::execute(parse(text), {folder("whole"), ""}, {});
  const recipe::Recipe recipe = parse(text);
  execute(recipe, {folder("tiles"), "", 200, 3000000}, {});
  EXPECT_TRUE(bytes_of(folder("tiles/coarse.npy")) == bytes_of(folder("whole/coarse.npy")));
}

TEST(TiledRun, SaysWhatDoesNotFitAndWhatToDo) {
  const io::TestFolder folder;
  const std::string message = message_of(kWorld, {folder("out"), "", 200, 20000000});
  EXPECT_THAT(message, HasSubstr("step 'isle' (classify.terrain) looks at everything: 998 x 853 cells"));
  EXPECT_THAT(message, HasSubstr("--memory"));
  EXPECT_FALSE(fs::exists(folder("out")));
}

TEST(TiledRun, NamesTheTileThatFails) {
  const io::TestFolder folder;
  const std::string message = message_of(R"({"seamount": 1, "domain": {"width_m": 8000, "height_m": 8000, "cell_m": 20},
    "steps": [{"id": "hills", "op": "terrain.noise", "params": {"kind": "smooth"}},
              {"id": "some", "op": "terrain.mask", "params": {"criteria": [{"tool": "region"}]}}],
    "outputs": [{"from": "some", "path": "a.tif"}]})",
                                         {folder("out"), "", 256, 0});
  EXPECT_THAT(message, HasSubstr("tile 1 of row 1 (columns 0 to 255, rows 0 to 255)"));
  EXPECT_THAT(message, HasSubstr("step 'some' (terrain.mask)"));
}

/// Cells without a value are filled as in a run of the whole, which is said.
TEST(TiledRun, UnknownCellsAreLookedAtAsAWhole) {
  const io::TestFolder folder;
  HeightField holed(GridFrame{400, 300, 25.0, 1000.0, 2000.0, "EPSG:32627"});
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 400; ++x)
      holed(x, y) = std::hypot(x - 250.F, y - 120.F) < 30.F ? NAN : 0.1F * static_cast<float>(x * (y % 17));
  }
  io::write_heights(holed, folder("holed.tif"));
  const std::string text = R"({"seamount": 1, "domain": {"crs": "EPSG:32627", "x_m": 5000, "y_m": -2000},
    "steps": [{"id": "dem", "op": "terrain.import", "params": {"file": ")" +
                           folder("holed.tif") + R"("}},
              {"id": "steep", "op": "terrain.mask", "params": {"criteria": [{"tool": "slope", "scale_m": 60}]}},
              {"id": "soft", "op": "terrain.smooth", "in": {"terrain": "dem"}, "params": {"radius_m": 60}}],
    "outputs": [{"from": "steep", "path": "steep.tif"}, {"from": "soft", "path": "soft.tif"}]})";
  std::vector<std::string> said;
  execute(parse(text), {folder("tiles"), folder("cache"), 128, 0},
          {.note = [&](const std::string& line) { said.push_back(line); }});
  recipe::execute(parse(text), {folder("whole"), ""}, {});
  for (const char* name : {"steep.tif", "soft.tif"}) {
    const ScalarField a = io::read_field(folder(std::string("tiles/") + name)),
                      b = io::read_field(folder(std::string("whole/") + name));
    EXPECT_EQ(a.frame(), b.frame());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(float)), 0) << name;
  }
  EXPECT_THAT(said, ::testing::Contains(HasSubstr("step 'soft' (terrain.smooth): some cells have no value")));
}

}  // namespace
}  // namespace seamount::tiles
