#include "seamount/geom/grid/pyramid.h"

#include <gtest/gtest.h>

#include "seamount/base/rng.h"
#include "seamount/geom/grid/resample.h"

namespace seamount::geom {
namespace {

Grid<float> random_grid(int width, int height) {
  Grid<float> grid({width, height, 3.0, 7, 9, {}});
  Rng rng(Seed{5});
  for (float& v : grid.cells()) v = static_cast<float>(rng.uniform(-1, 1));
  return grid;
}

TEST(Pyramid, HalvesByMeansAndKeepsTheCorner) {
  const Grid<float> grid = random_grid(7, 4);
  const Grid<float> half = halved(grid, {});
  ASSERT_EQ(half.width(), 4);
  ASSERT_EQ(half.height(), 2);
  EXPECT_EQ(half.cell_m(), 6.0);
  EXPECT_EQ(half.frame().west_m, 7);
  EXPECT_NEAR(half(1, 1), 0.25F * (grid(2, 2) + grid(3, 2) + grid(2, 3) + grid(3, 3)), 1e-6);
  EXPECT_NEAR(half(3, 0), 0.5F * (grid(6, 0) + grid(6, 1)), 1e-6);
  EXPECT_EQ(halved(random_grid(1, 1), {})(0, 0), random_grid(1, 1)(0, 0));
}

TEST(Pyramid, DoublesLikeTheBicubicSampler) {
  for (const auto& [width, height] : {std::pair(1, 1), {2, 5}, {9, 6}, {16, 3}}) {
    const Grid<float> fine = random_grid(width, height);
    const Grid<float> half = halved(fine, {});
    const Grid<float> twice = doubled(half, fine.frame(), {});
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        EXPECT_NEAR(twice(x, y), sample_bicubic(half, x / 2.0 - 0.25, y / 2.0 - 0.25), 1e-5) << x << ' ' << y;
      }
    }
  }
}

TEST(Pyramid, GrowsLevelByLevel) {
  const Grid<float> grid = random_grid(12, 12);
  Pyramid pyramid(grid);
  EXPECT_EQ(pyramid.top(), 0U);
  pyramid.grow({});
  pyramid.grow({});
  EXPECT_EQ(pyramid.top(), 2U);
  EXPECT_EQ(&pyramid[0], &grid);
  EXPECT_EQ(pyramid[2].width(), 3);
}

}  // namespace
}  // namespace seamount::geom
