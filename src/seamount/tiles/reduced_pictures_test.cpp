#include "seamount/tiles/reduced_pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "seamount/io/image_file.h"
#include "seamount/tiles/run.h"

namespace seamount::tiles {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("seamount_pictures_" + std::to_string(::getpid()))) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

const char* const kSteps = R"({"seamount": 1, "seed": 4,
  "domain": {"width_m": 9000, "height_m": 7000, "cell_m": 23.7},
  "steps": [
    {"id": "hills", "op": "terrain.noise", "params": {"wavelength_m": 2500, "height_m": 900, "base_m": -120}},
    {"id": "steep", "op": "terrain.mask", "params": {"criteria": [{"tool": "slope", "low_deg": 14, "scale_m": 150}]}}],
  "outputs": )";

recipe::Recipe parse(const std::string& outputs) {
  return recipe::parse_recipe(kSteps + outputs + "}", "world.json", "");
}

TEST(ReducedPictures, ShowTheWholeFromLargerCellsAndSaySo) {
  const Folder folder;
  const std::string outputs = R"([
    {"from": "hills", "path": "map.png", "as": "map", "width_px": 200},
    {"from": "hills", "path": "view.png", "as": "perspective", "width_px": 160, "height_px": 90},
    {"from": "hills", "path": "relief.png", "as": "relief", "width_px": 90}])";
  const recipe::Recipe recipe = parse(outputs);
  recipe::execute(recipe, {folder / "whole", ""}, {});
  std::vector<std::string> said;
  execute(recipe, {folder / "tiled", folder / "cache", 128, 2000000},
          {.note = [&](const std::string& line) { said.push_back(line); }});
  EXPECT_THAT(said,
              Contains(HasSubstr("380 x 295 cells do not fit: the picture is made from means over 2 x 2 of them")));
  for (const std::string name : {"map.png", "relief.png", "view.png"}) {
    const Image whole = io::read_image(folder / ("whole/" + name)),
                reduced = io::read_image(folder / ("tiled/" + name));
    ASSERT_EQ(reduced.width, whole.width) << name;
    ASSERT_LE(std::abs(reduced.height - whole.height), 1) << name;
    double off = 0;
    const int rows = std::min(whole.height, reduced.height);
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < whole.width; ++x) off += std::abs(whole.colour(x, y).g - reduced.colour(x, y).g);
    EXPECT_LT(off / whole.width / rows, 12.0) << name << ": much the same picture";
    EXPECT_GT(off, 0.0) << name << " is from other cells";
  }
}

}  // namespace
}  // namespace seamount::tiles
