#include "seamount/geom/solve/fill_voids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"
#include "seamount/geom/grid/voids.h"
#include "seamount/model/sample_known.h"

namespace seamount::geom {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

Grid<float> plane(int width, int height) {
  Grid<float> grid(GridFrame::centred(width, height, 30.0));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) grid(x, y) = static_cast<float>(100 + 3 * x - 2 * y);
  return grid;
}

/// Holes of many shapes within a plane: the membrane through their rims is the plane.
TEST(FillVoids, IsThePlaneThroughItsRim) {
  for (const uint64_t seed : {1, 2, 3}) {
    const Grid<float> whole = plane(80, 60);
    Grid<float> holes = whole;
    Rng rng(Seed{seed});
    int64_t made = 0;
    for (int k = 0; k < 12; ++k) {
      const double x0 = rng.uniform(8, 72), y0 = rng.uniform(8, 52), r = rng.uniform(1, 6);
      for (int y = 1; y < 59; ++y)
        for (int x = 1; x < 79; ++x)
          if (std::hypot(x - x0, (y - y0) * 1.5) < r) holes(x, y) = kNone;
    }
    for (const float z : holes.cells()) made += std::isnan(z) ? 1 : 0;
    ASSERT_EQ(count_voids(holes, {}), made);
    Grid<float> filled = holes;
    EXPECT_EQ(fill_voids(filled, {}), made);
    for (size_t i = 0; i < whole.size(); ++i) {
      if (!std::isnan(holes.cells()[i])) {
        ASSERT_EQ(filled.cells()[i], holes.cells()[i]);
      }
      ASSERT_NEAR(filled.cells()[i], whole.cells()[i], 0.1) << "seed " << seed << " cell " << i;
    }
    Grid<float> again = holes;
    RunContext two;
    two.threads = 2;
    fill_voids(again, two);
    EXPECT_EQ(again, filled);
  }
}

/// Hole by hole, in windows cut out of the grid, with other holes in them.
TEST(FillVoids, OfAWindowHasTheValuesOfTheWhole) {
  for (const uint64_t seed : {1, 2, 3}) {
    Grid<float> holes = plane(90, 70);
    Rng rng(Seed{seed});
    for (float& z : holes.cells()) z += static_cast<float>(rng.uniform(0, 40));
    const auto dig = [&](int x0, int y0, int width, int height) {
      for (int y = y0; y < y0 + height; ++y)
        for (int x = x0; x < x0 + width; ++x) holes(x, y) = kNone;
    };
    dig(20, 20, 17, 9);
    dig(20, 29, 4, 6);  // hangs together with it
    dig(30, 31, 5, 4);  // in its window, and not of it
    dig(0, 50, 3, 20);  // at the edge
    Grid<float> whole = holes;
    fill_voids(whole, {});
    const auto compare = [&](int x0, int y0, int width, int height, int first_x, int first_y) {
      Grid<float> window(holes.frame().window(x0, y0, width, height));
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) window(x, y) = holes(x0 + x, y0 + y);
      const Grid<float> before = window;
      fill_hole(window, int64_t{first_y - y0} * width + first_x - x0, {});
      int filled = 0;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          if (std::isnan(window(x, y))) continue;
          ASSERT_EQ(window(x, y), whole(x0 + x, y0 + y)) << x << ", " << y;
          filled += std::isnan(before(x, y)) ? 1 : 0;
        }
      }
      EXPECT_EQ(filled, first_x == 0 ? 60 : first_x == 30 ? 20 : 17 * 9 + 24);
    };
    compare(19, 19, 19, 17, 20, 20);
    compare(29, 30, 7, 6, 30, 31);
    compare(0, 49, 4, 21, 0, 50);
  }
}

/// Gaps between swaths: long, slanting, many; their windows are the whole grid each.
TEST(FillVoids, OfManySlantingGapsIsThePlaneToo) {
  const Grid<float> whole = plane(120, 100);
  Grid<float> gaps = whole;
  for (int y = 1; y < 99; ++y)
    for (int x = 1; x < 119; ++x)
      if ((x + y / 2) % 10 < 3) gaps(x, y) = kNone;
  fill_voids(gaps, {});
  for (size_t i = 0; i < whole.size(); ++i) ASSERT_NEAR(gaps.cells()[i], whole.cells()[i], 0.1) << i;
}

TEST(FillVoids, StaysWithinItsRimAndReachesTheEdge) {
  Grid<float> grid = plane(40, 30);
  for (int y = 0; y < 30; ++y)
    for (int x = 25; x < 40; ++x) grid(x, y) = kNone;
  fill_voids(grid, {});
  for (int y = 0; y < 30; ++y) {
    for (int x = 25; x < 40; ++x) {
      ASSERT_GE(grid(x, y), grid(24, 29) - 0.5F);
      ASSERT_LE(grid(x, y), grid(24, 0) + 0.5F);
    }
  }
}

TEST(FillVoids, NeedsSomethingToGoBy) {
  Grid<float> nothing(GridFrame::centred(5, 4, 1.0), kNone);
  EXPECT_THROW(fill_voids(nothing, {}), IncompatibleInputs);
  Grid<float> one = nothing;
  one(2, 2) = 7.0F;
  EXPECT_EQ(fill_voids(one, {}), 19);
  for (const float z : one.cells()) EXPECT_NEAR(z, 7.0F, 1e-3);
}

TEST(SampleKnown, CountsWhatIsKnownAndNothingBeyondTheEdge) {
  Grid<float> grid = plane(4, 3);
  EXPECT_FLOAT_EQ(sample_known(grid, 1.5, 1.0), 102.5F);
  EXPECT_FLOAT_EQ(sample_known(grid, -0.5, 0.0), grid(0, 0));
  EXPECT_TRUE(std::isnan(sample_known(grid, -0.51, 0.0)));
  EXPECT_TRUE(std::isnan(sample_known(grid, 3.6, 0.0)));
  grid(2, 1) = kNone;
  EXPECT_FLOAT_EQ(sample_known(grid, 1.4, 1.0), grid(1, 1));
  EXPECT_TRUE(std::isnan(sample_known(grid, 1.6, 1.0)));
}

}  // namespace
}  // namespace seamount::geom
