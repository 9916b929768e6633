// Filling and flow over the borders of tiles against the operators on the whole: equal bytes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
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
};
// clang-format on

class TiledWater : public ::testing::TestWithParam<Case> {
 protected:
  std::string folder(const std::string& name) const { return folder_(name); }
  std::string text() const { return recipe_of(GetParam().steps, GetParam().fill, GetParam().flow); }

 private:
  io::TestFolder folder_;
};

TEST_P(TiledWater, HasTheBytesOfTheWhole) {
  const recipe::Recipe recipe = recipe::parse_recipe(text(), "water.json", "");
  recipe::execute(recipe, {folder("whole"), ""}, {});
  for (const int tile : {150, 61}) {
    const std::string out = folder(std::to_string(tile));
    std::vector<std::string> said;
    constexpr uint64_t kTooLittle = 3000000;  // for 383 x 303 cells as a whole
    execute(recipe, {out, "", tile, kTooLittle}, {.note = [&](const std::string& line) { said.push_back(line); }});
    for (const char* name :
         {"filled.tif", "change.tif", "cells.tif", "area.tif", "direction.tif", "basins.tif", "surface.tif"}) {
      const ScalarField a = io::read_field(out + "/" + name), b = io::read_field(folder("whole") + "/" + name);
      ASSERT_EQ(a.frame(), b.frame());
      int64_t differ = 0, first = -1;
      for (size_t i = 0; i < a.size(); ++i) {
        if (a.data()[i] == b.data()[i]) continue;
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
