// Cells without a value, into files and back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "seamount/io/atomic_file.h"
#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using testing::HasSubstr;

TEST(Voids, ComeBackFromEveryFormatThatHoldsThem) {
  for (const float low : {100.0F, -9500.0F}) {  // near it -9999 is a depth
    HeightField heights = test_terrain(GridFrame{7, 5, 30.0, 5e5, 4e6, "EPSG:32633"});
    heights(1, 1) = low;
    heights(0, 0) = heights(3, 2) = heights(6, 4) = std::nanf("");
    const TestFolder folder;
    for (const std::string& extension : writable_raster_extensions()) {
      if (!can_hold_voids("x" + extension)) continue;
      const std::string path = folder("x" + extension);
      write_heights(heights, path);
      const HeightField back = read_heights(path);
      ASSERT_EQ(back.size(), heights.size()) << extension;
      for (size_t i = 0; i < heights.size(); ++i) {
        EXPECT_EQ(std::isnan(back.cells()[i]), std::isnan(heights.cells()[i])) << extension << " cell " << i;
        if (std::isnan(heights.cells()[i])) continue;
        EXPECT_EQ(back.cells()[i], heights.cells()[i]) << extension;
      }
      EXPECT_EQ(raster_info(path).void_cells, 3) << extension;
    }
  }
}

/// ASC text with the given cells.
std::string asc(const std::string& cells) {
  return "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -9999\n" + cells;
}

TEST(Voids, StayAndAreSaid) {
  const TestFolder folder;
  write_text(folder("holes.asc"), asc("1.5 1.5 1.5\n1.5 -9999 1.5\n"));
  std::vector<std::string> notes;
  ReadOptions options;
  options.run.note = [&](const std::string& line) { notes.push_back(line); };
  const HeightField holes = read_heights(folder("holes.asc"), options);
  EXPECT_THAT(notes, testing::ElementsAre(HasSubstr("1 of 6 cells have no value")));
  EXPECT_TRUE(std::isnan(holes(1, 1)));
  EXPECT_FLOAT_EQ(holes(0, 1), 1.5F);
  write_text(folder("empty.asc"), asc("-9999 -9999 -9999\n-9999 -9999 -9999\n"));
  EXPECT_THAT(error_of([&] { read_heights(folder("empty.asc")); }), HasSubstr("none of its 6"));
  EXPECT_EQ(raster_info(folder("holes.asc")).void_cells, 1);
}

}  // namespace
}  // namespace seamount::io
