// Filling and flow over the borders of tiles against the operators on the whole: equal bytes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"
#include "seamount/tiles/run.h"
#include "seamount/tiles/test_world.h"

namespace seamount::tiles {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// `ground` names the step to drain; `params` of both operators.
std::string recipe_of(const std::string& steps, const std::string& fill, const std::string& flow) {
  return R"({"seamount": 1, "seed": 3, "domain": {"width_m": 12000, "height_m": 9500, "cell_m": 31.3}, "steps": [)" +
         steps + R"(,
    {"id": "filled", "op": "hydrology.fill", "in": {"terrain": "ground"}, "params": {)" +
         fill + R"(}},
    {"id": "flow", "op": "hydrology.flow", "in": {"terrain": "ground"}, "params": {)" +
         flow + R"(}}],
  "outputs": [{"from": "filled.terrain", "path": "filled.tif"}, {"from": "filled.change", "path": "change.tif"},
    {"from": "flow.cells", "path": "cells.tif"}, {"from": "flow.area", "path": "area.tif"},
    {"from": "flow.basins", "path": "basins.tif"}, {"from": "flow.direction", "path": "direction.tif"}, {"from": "flow.terrain", "path": "surface.tif"},
    {"from": "filled.lakes", "path": "lakes.geojson"}, {"from": "flow.catchments", "path": "catchments.geojson"}]})";
}

struct Case {
  const char* name;
  const char* steps;
  const char* fill = "";
  const char* flow = "";
};

// clang-format off
const Case kCases[] = {
    {"islands", R"({"id": "ground", "op": "terrain.noise", "params": {"wavelength_m": 4000, "base_m": -320}})"},
    {"no_sea", R"({"id": "ground", "op": "terrain.noise", "params": {"kind": "ridged", "wavelength_m": 3000}})",
     R"("sea": false)", R"("sea": false)"},
    {"flat_only_to_outlets", R"({"id": "ground", "op": "terrain.noise", "params": {"kind": "smooth", "wavelength_m": 900, "base_m": 50}})",
     R"("descend": false, "min_sea_m2": 1e5)", R"("min_sea_m2": 1e5)"},
    {"level_ground", R"({"id": "rough", "op": "terrain.noise", "params": {"kind": "smooth", "wavelength_m": 2500, "base_m": 60}},
       {"id": "level", "op": "terrain.noise", "params": {"kind": "smooth", "height_m": 0, "base_m": 75}},
       {"id": "ground", "op": "terrain.blend", "in": {"terrain": "rough", "with": "level"}, "params": {"mode": "max"}})"},
    {"lakes_of_one_height", R"({"id": "rough", "op": "terrain.noise", "params": {"kind": "smooth", "wavelength_m": 1500, "base_m": 200}},
       {"id": "level", "op": "terrain.noise", "params": {"kind": "smooth", "height_m": 0, "base_m": 220}},
       {"id": "ground", "op": "terrain.blend", "in": {"terrain": "rough", "with": "level"}, "params": {"mode": "min"}})"},
    {"one_lake_with_islands", R"({"id": "file", "op": "terrain.import", "params": {"file": "lake.tif"}},
       {"id": "ground", "op": "terrain.resample", "in": {"terrain": "file"}, "params": {"beyond": "edge"}})", R"("sea": false)", R"("sea": false)"},
    {"a_lake_between_walls", R"({"id": "file", "op": "terrain.import", "params": {"file": "spiral.tif"}},
       {"id": "ground", "op": "terrain.resample", "in": {"terrain": "file"}, "params": {"beyond": "edge"}})"},
};
// clang-format on

/// Deep ground between walls along the edge, with a way out and cells without a value.
HeightField basin() {
  HeightField ground(GridFrame::centred(96, 76, 125.0), 300.0F);
  for (int y = 1; y < 75; ++y)
    for (int x = 1; x < 95; ++x) ground(x, y) = static_cast<float>(20 + (7 * x + 5 * y) % 11);
  ground(0, 40) = ground(1, 40) = 100.0F;
  return ground;
}
HeightField lake_with_islands() {
  HeightField ground = basin();
  for (int y = 5; y < 70; y += 9)
    for (int x = 4 + y % 4; x < 90; x += 11) ground(x, y) = ground(x + 1, y) = 170.0F;
  ground(60, 33) = ground(61, 33) = std::numeric_limits<float>::quiet_NaN();
  return ground;
}
/// Walls in rings, each with a gap on another side.
HeightField ways_around() {
  HeightField ground = basin();
  for (int ring = 4; ring < 36; ring += 4) {
    for (int x = ring; x < 96 - ring; ++x) ground(x, ring) = ground(x, 75 - ring) = 200.0F;
    for (int y = ring; y < 76 - ring; ++y) ground(ring, y) = ground(95 - ring, y) = 200.0F;
    const int gap = ring % 8 == 0 ? ring : 95 - ring;
    ground(gap, ring + 1) = ground(gap, ring + 2) = 25.0F;
  }
  return ground;
}

class TiledWater : public ::testing::TestWithParam<Case> {
 protected:
  std::string folder(const std::string& name) const { return folder_(name); }
  std::string text() const { return recipe_of(GetParam().steps, GetParam().fill, GetParam().flow); }

 private:
  io::TestFolder folder_;
};

TEST_P(TiledWater, HasTheBytesOfTheWhole) {
  io::write_heights(lake_with_islands(), folder("lake.tif"));
  io::write_heights(ways_around(), folder("spiral.tif"));
  const recipe::Recipe recipe = recipe::parse_recipe(text(), "water.json", folder(""));
  recipe::execute(recipe, {folder("whole"), ""}, {});
  for (const int tile : {150, 61}) {
    const std::string out = folder(std::to_string(tile));
    std::vector<std::string> said;
    constexpr uint64_t kTooLittle = 4000000;  // for 383 x 303 cells as a whole, but enough to trace one lake
    execute(recipe, {out, "", tile, kTooLittle}, {.note = [&](const std::string& line) { said.push_back(line); }});
    for (const char* name :
         {"filled.tif", "change.tif", "cells.tif", "area.tif", "direction.tif", "basins.tif", "surface.tif"}) {
      const ScalarField a = io::read_field(out + "/" + name), b = io::read_field(folder("whole") + "/" + name);
      ASSERT_EQ(a.frame(), b.frame());
      int64_t differ = 0, first = -1;
      for (size_t i = 0; i < a.size(); ++i) {
        if (a.data()[i] == b.data()[i] || (std::isnan(a.data()[i]) && std::isnan(b.data()[i]))) continue;
        ++differ;
        if (first < 0) first = static_cast<int64_t>(i);
      }
      EXPECT_EQ(differ, 0) << name << " in tiles of " << tile << ", first at column " << first % a.width() << ", row "
                           << first / a.width();
    }
    for (const char* name : {"lakes.geojson", "catchments.geojson"})
      EXPECT_TRUE(bytes_of(out + "/" + name) == bytes_of(folder("whole") + "/" + name))
          << name << ", tiles of " << tile;
  }
}

INSTANTIATE_TEST_SUITE_P(Grounds, TiledWater, ::testing::ValuesIn(kCases),
                         [](const ::testing::TestParamInfo<Case>& one) { return std::string(one.param.name); });

TEST(TiledWaterRefusal, SaysWhatLooksAtEverything) {
  const std::string text = R"({"seamount": 1, "domain": {"width_m": 12000, "height_m": 9500, "cell_m": 31.3}, "steps": [
    {"id": "ground", "op": "terrain.noise"},
    {"id": "flow", "op": "hydrology.flow", "params": {"method": "mfd"}}],
    "outputs": [{"from": "flow.cells", "path": "cells.tif"}]})";
  const std::string out = (fs::temp_directory_path() / "seamount_water_refused").string();
  try {
    execute(recipe::parse_recipe(text, "water.json", ""), {out, "", 100, 3000000}, {});
    FAIL() << "it cannot fit";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("step 'flow' (hydrology.flow) looks at everything (only the method d8 is run in tiles)"));
  }
}

}  // namespace
}  // namespace seamount::tiles
