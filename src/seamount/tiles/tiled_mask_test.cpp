// terrain.mask by depth over the borders of tiles against the whole: equal bytes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"
#include "seamount/tiles/run.h"

namespace seamount::tiles {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string text_of(int seed, const std::string& criteria) {
  return R"({"seamount": 1, "seed": )" + std::to_string(seed) +
         R"(, "domain": {"width_m": 12000, "height_m": 9500, "cell_m": 31.3}, "steps": [
    {"id": "ground", "op": "terrain.noise", "params": {"kind": "smooth", "wavelength_m": 300, "base_m": 80}},
    {"id": "some", "op": "terrain.mask", "params": {"criteria": [)" +
         criteria + R"(]}}],
    "outputs": [{"from": "some", "path": "mask.tif"}, {"from": "ground", "path": "ground.tif"}]})";
}

class TiledMask : public ::testing::Test {
 protected:
  std::string folder(const std::string& name) const { return folder_(name); }

  void expect_same(const std::string& text) const {
    const recipe::Recipe recipe = recipe::parse_recipe(text, "mask.json", "");
    recipe::execute(recipe, {folder("whole"), ""}, {});
    const ScalarField whole = io::read_field(folder("whole") + "/mask.tif");
    for (const int tile : {150, 61}) {
      const std::string out = folder(std::to_string(tile));
      execute(recipe, {out, folder("cache"), tile, 3000000}, {});
      const ScalarField tiled = io::read_field(out + "/mask.tif");
      ASSERT_EQ(tiled.frame(), whole.frame());
      EXPECT_EQ(std::memcmp(tiled.data(), whole.data(), whole.size() * sizeof(float)), 0) << "in tiles of " << tile;
      EXPECT_TRUE(fs::is_empty(folder("cache") + "/tiles"));
    }
  }

 private:
  io::TestFolder folder_;
};

TEST_F(TiledMask, DepthAloneAndBesideWhatLooksAround) {
  for (const int seed : {3, 4, 5}) {
    expect_same(text_of(seed, R"({"tool": "depth"})"));
    const ScalarField mask = io::read_field(folder("whole") + "/mask.tif");
    const HeightField ground = io::read_heights(folder("whole") + "/ground.tif");
    int sea = 0, hollows = 0;
    for (size_t i = 0; i < mask.size(); ++i) {
      sea += ground.data()[i] < 0.0F && mask.data()[i] == 1.0F;
      hollows += ground.data()[i] < 0.0F && mask.data()[i] == 0.0F;
    }
    EXPECT_GT(sea, 100) << "nothing to find";
    EXPECT_GT(hollows, 100) << "nothing to go wrong";
  }
  expect_same(
      text_of(6, R"({"tool": "noise", "coverage": 0.6}, {"tool": "depth", "low_m": 3, "high_m": 40, "invert": true},
                            {"tool": "slope", "low_deg": 4, "scale_m": 120})"));
}

TEST_F(TiledMask, SaysWhatItCannotGoWith) {
  try {
    execute(recipe::parse_recipe(text_of(3, R"({"tool": "depth"}, {"tool": "value"})"), "mask.json", ""),
            {folder("out"), "", 100, 3000000}, {});
    FAIL() << "it cannot fit";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("step 'some' (terrain.mask) looks at everything (depth together with value"));
  }
}

}  // namespace
}  // namespace seamount::tiles
