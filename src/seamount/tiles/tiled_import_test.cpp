// Elevation that does not fit into memory: imported window by window, with the bytes of the whole run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include "seamount/base/rng.h"
#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"
#include "seamount/tiles/run.h"

namespace seamount::tiles {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;

class TiledImport : public ::testing::Test {
 protected:
  std::string folder(const std::string& name) const { return folder_(name); }

  /// A terrain of 430 x 371 cells in a file.
  std::string dem(const std::string& name, GridFrame frame, bool hole, double radius = 30) const {
    frame.width = 430;
    frame.height = 371;
    HeightField made(frame);
    for (int y = 0; y < made.height(); ++y) {
      for (int x = 0; x < made.width(); ++x) {
        made(x, y) = static_cast<float>(700 * std::sin(0.021 * x) * std::cos(0.035 * y) + 3 * ((x * 7 + y * 13) % 29));
        if (hole && std::hypot(x - 120, y - 200) < radius) made(x, y) = std::numeric_limits<float>::quiet_NaN();
      }
    }
    io::write_heights(made, folder(name));
    return folder(name);
  }

  static std::string text(const std::string& file, const std::string& params, const std::string& domain) {
    return R"({"seamount": 1, "domain": {)" + domain + R"(}, "steps": [
      {"id": "dem", "op": "terrain.import", "params": {"file": ")" +
           file + R"(")" + params + R"(}},
      {"id": "high", "op": "terrain.mask", "params": {"criteria": [{"tool": "height", "low_m": 100}]}},
      {"id": "both", "op": "terrain.blend", "in": {"terrain": "dem", "with": "dem", "mask": "high"}, "params": {"mode": "add", "strength": 0.3}}],
      "outputs": [{"from": "dem", "path": "dem.tif"}, {"from": "both", "path": "both.tif"}]})";
  }

  void expect_same(const std::string& recipe_text) {
    const recipe::Recipe recipe = recipe::parse_recipe(recipe_text, "import.json", "");
    std::vector<std::string> expected;
    recipe::execute(recipe, {folder("whole"), ""},
                    {.note = [&](const std::string& line) { expected.push_back(line); }});
    for (const int tile : {128, 97}) {
      const std::string out = folder(std::to_string(tile));
      std::vector<std::string> said;
      constexpr uint64_t kTooLittle = 1200000;  // for 430 x 371 cells as a whole
      execute(recipe, {out, folder("cache"), tile, kTooLittle},
              {.note = [&](const std::string& line) { said.push_back(line); }});
      for (const char* name : {"dem.tif", "both.tif"}) {
        const HeightField a = io::read_heights(out + "/" + name), b = io::read_heights(folder("whole") + "/" + name);
        ASSERT_EQ(a.frame(), b.frame());
        EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(float)), 0) << name << " in tiles of " << tile;
      }
      EXPECT_EQ(said.size(), expected.size());
      EXPECT_TRUE(fs::is_empty(folder("cache") + "/tiles"));
    }
  }

  std::string error_of(const std::string& recipe_text) const {
    try {
      execute(recipe::parse_recipe(recipe_text, "import.json", ""), {folder("out"), "", 128, 1200000}, {});
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

 private:
  io::TestFolder folder_;
};

TEST_F(TiledImport, InMetresWithItsOwnCells) {
  const std::string file = dem("utm.tif", {0, 0, 12.5, 400000.25, 5.1e6, "EPSG:32632"}, true);
  expect_same(text(file, "", R"("crs": "EPSG:32632", "x_m": 403000, "y_m": 5097000)"));
}

TEST_F(TiledImport, WithoutASystem) {
  expect_same(text(dem("local.tif", {0, 0, 31.3, -100.5, 200, ""}, false), "", R"("width_m": 9000, "height_m": 9000)"));
}

TEST_F(TiledImport, WarpedToMetres) {
  expect_same(text(dem("far.tif", {0, 0, 30, 1e6, 9e6, "EPSG:3857"}, true), "",
                   R"("crs": "EPSG:32633", "x_m": 403000, "y_m": 5097000)"));
}

/// Small ones, ones on borders and corners of tiles, one around another, one on the raster's edge, one of a single
/// cell.
TEST_F(TiledImport, FillsHolesAsTheWholeDoes) {
  for (const uint64_t seed : {5, 6, 7}) {
    const double cell_m = seed == 6 ? 90 : 12.5;
    const std::string file = dem("holes.tif", {0, 0, cell_m, 400000.25, 5.1e6, "EPSG:32632"}, true);
    HeightField heights = io::read_heights(file);
    Rng rng(Seed{seed});
    for (int k = 0; k < 60; ++k) {
      const double x0 = rng.uniform(0, 430), y0 = rng.uniform(0, 371), r = rng.uniform(0.5, 9),
                   ring = rng.uniform(0, r);
      for (int y = 0; y < heights.height(); ++y)
        for (int x = 0; x < heights.width(); ++x)
          if (const double d = std::hypot(x - x0, 1.4 * (y - y0)); d < r && (k % 3 != 0 || d > ring))
            heights(x, y) = std::numeric_limits<float>::quiet_NaN();
    }
    io::write_heights(heights, file);
    expect_same(text(file, R"(, "fill_voids": true)", ""));
  }
}

TEST_F(TiledImport, SaysWhatIsReadAsAWhole) {
  const std::string file = dem("utm.tif", {0, 0, 12.5, 400000.25, 5.1e6, "EPSG:32632"}, true);
  const std::string wide = dem("wide.tif", {0, 0, 12.5, 400000.25, 5.1e6, "EPSG:32632"}, true, 180);
  EXPECT_THAT(
      error_of(text(wide, R"(, "fill_voids": true)", "")),
      HasSubstr("step 'dem' (terrain.import) looks at everything (a hole of 300 x 350 cells is filled as a whole)"));
  EXPECT_THAT(error_of(text(folder("none.tif"), "", "")), HasSubstr("none.tif"));
}

}  // namespace
}  // namespace seamount::tiles
