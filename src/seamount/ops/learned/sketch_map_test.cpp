#include "seamount/ops/learned/sketch_map.h"

#include <gtest/gtest.h>

namespace seamount::learned {
namespace {

TEST(DrawCells, ALineOnTheEdgeIsInTheOuterCells) {
  const GridFrame frame{8, 4, 10, 0, 40};
  Grid<uint8_t> cells(frame, 0);
  EXPECT_TRUE(draw_cells({{0, 40}, {0, 0.1}}, cells));     // the western edge lies half a cell from the first centre
  EXPECT_FALSE(draw_cells({{80, 40}, {80, 0.1}}, cells));  // the eastern one belongs to the next sheet
  for (int y = 0; y < 4; ++y) {
    EXPECT_EQ(cells(0, y), 1) << y;
    EXPECT_EQ(cells(7, y), 0) << y;
  }
}

}  // namespace
}  // namespace seamount::learned
