// terrain.resample and terrain.crop tile by tile against the whole: from a file's cells to the domain's and to others.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"
#include "seamount/tiles/run.h"

namespace seamount::tiles {
namespace {

namespace fs = std::filesystem;

struct Case {
  const char* name;
  const char* op;
  const char* params;
  const char* domain;
};

// clang-format off
const Case kCases[] = {
    {"onto_smaller_cells", "terrain.resample", R"("centre": false)", R"("width_m": 9000, "height_m": 7000, "cell_m": 11.3)"},
    {"onto_larger_cells", "terrain.resample", R"("centre": false)", R"("width_m": 9000, "height_m": 7000, "cell_m": 47.1)"},
    {"in_the_middle_beyond_the_edge", "terrain.resample", R"("centre": true, "beyond": "edge")", R"("width_m": 17000, "height_m": 15000, "cell_m": 30)"},
    {"of_one_lattice", "terrain.resample", R"("centre": false)", R"("width_m": 6260, "height_m": 6260, "cell_m": 31.3)"},
    {"stretched", "terrain.resample", R"("scale": 1.7)", R"("width_m": 17000, "height_m": 15000, "cell_m": 40)"},
    {"to_smaller_cells", "terrain.resample", R"("cell_m": 19.99)", R"("width_m": 900)"},
    {"cut_out_in_the_middle", "terrain.crop", R"("width_m": 5000.7, "height_m": 3000)", R"("width_m": 900)"},
    {"cut_out_around_the_summit", "terrain.crop", R"("width_m": 5000.7, "around": "highest")", R"("width_m": 900)"},
    {"cut_out_around_the_deepest", "terrain.crop", R"("width_m": 3000.7, "around": "lowest")", R"("width_m": 900)"},
    {"cut_out_at_a_place", "terrain.crop", R"("width_m": 5000.7, "x_m": 5000, "y_m": -1234)", R"("width_m": 900)"},
    {"to_larger_cells_stretched", "terrain.resample", R"("cell_m": 120, "scale": 2.3)", R"("width_m": 900)"},
};
// clang-format on

class TiledResample : public ::testing::TestWithParam<Case> {
 protected:
  std::string folder(const std::string& name) const { return folder_(name); }

 private:
  io::TestFolder folder_;
};

TEST_P(TiledResample, HasTheBytesOfTheWhole) {
  HeightField made(GridFrame{380, 351, 31.3, -6000.7, 5432.1});
  for (int y = 0; y < made.height(); ++y) {
    for (int x = 0; x < made.width(); ++x) {
      made(x, y) = static_cast<float>(700 * std::sin(0.021 * x) * std::cos(0.035 * y) + 3 * ((x * 7 + y * 13) % 29));
      if (std::hypot(x - 150, y - 180) < 20) made(x, y) = std::numeric_limits<float>::quiet_NaN();
    }
  }
  io::write_heights(made, folder("dem.tif"));
  const recipe::Recipe recipe = recipe::parse_recipe(R"({"seamount": 1, "domain": {)" + std::string(GetParam().domain) +
                                                         R"(}, "steps": [
      {"id": "dem", "op": "terrain.import", "params": {"file": ")" +
                                                         folder("dem.tif") +
                                                         R"("}},
      {"id": "laid", "op": ")" + GetParam().op + R"(", "params": {)" +
                                                         GetParam().params + R"(}}],
      "outputs": [{"from": "laid", "path": "laid.tif"}]})",
                                                     "resample.json", "");
  std::vector<std::string> expected;
  recipe::execute(recipe, {folder("whole"), ""}, {.note = [&](const std::string& line) { expected.push_back(line); }});
  const HeightField whole = io::read_heights(folder("whole") + "/laid.tif");
  for (const int tile : {128, 61}) {
    const std::string out = folder(std::to_string(tile));
    std::vector<std::string> said;
    constexpr uint64_t kTooLittle = 400000;  // for 380 x 351 cells
    execute(recipe, {out, folder("cache"), tile, kTooLittle},
            {.note = [&](const std::string& line) { said.push_back(line); }});
    const HeightField tiled = io::read_heights(out + "/laid.tif");
    ASSERT_EQ(tiled.frame(), whole.frame());
    EXPECT_EQ(std::memcmp(tiled.data(), whole.data(), whole.size() * sizeof(float)), 0) << "in tiles of " << tile;
    EXPECT_EQ(said, expected);
  }
}

INSTANTIATE_TEST_SUITE_P(Ways, TiledResample, ::testing::ValuesIn(kCases),
                         [](const ::testing::TestParamInfo<Case>& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace seamount::tiles
