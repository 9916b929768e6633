#include "seamount/tiles/reduced_pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "seamount/io/image_file.h"
#include "seamount/io/test_files.h"
#include "seamount/tiles/run.h"
#include "seamount/tiles/test_world.h"

namespace seamount::tiles {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;

TEST(ReducedPictures, ShowTheWholeFromLargerCellsAndSaySo) {
  const io::TestFolder folder;
  const std::string outputs = R"([
    {"from": "hills", "path": "map.png", "as": "map", "width_px": 200},
    {"from": "hills", "path": "view.png", "as": "perspective", "width_px": 160, "height_px": 90},
    {"from": "hills", "path": "relief.png", "as": "relief", "width_px": 90}])";
  const recipe::Recipe recipe = small_world(outputs);
  recipe::execute(recipe, {folder("whole"), ""}, {});
  std::vector<std::string> said;
  execute(recipe, {folder("tiled"), folder("cache"), 128, 2000000},
          {.note = [&](const std::string& line) { said.push_back(line); }});
  EXPECT_THAT(said,
              Contains(HasSubstr("380 x 295 cells do not fit: the picture is made from means over 2 x 2 of them")));
  for (const std::string name : {"map.png", "relief.png", "view.png"}) {
    const Image whole = io::read_image(folder("whole/" + name)), reduced = io::read_image(folder("tiled/" + name));
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
