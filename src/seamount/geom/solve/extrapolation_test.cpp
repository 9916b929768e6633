#include "seamount/geom/solve/extrapolation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/error.h"

namespace seamount::geom {
namespace {

/// A round island of 10 m that is known within 300 m.
HeightField island(int size, Grid<uint8_t>& covered) {
  const GridFrame frame = GridFrame::centred(size, size, 2000.0 / size);
  HeightField heights(frame, std::nanf(""));
  covered = Grid<uint8_t>(frame, uint8_t{0});
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      if (std::hypot(frame.x(x), frame.y(y)) > 300.0) continue;
      heights(x, y) = 10.0F;
      covered(x, y) = 1;
    }
  }
  return heights;
}

TEST(Extrapolation, FallsFromTheBorderWithTheSlope) {
  for (const int size : {100, 500, 1400}) {
    Grid<uint8_t> covered;
    HeightField heights = island(size, covered);
    extrapolate_ground(heights, covered, 0.05, {});
    const GridFrame& f = heights.frame();
    const auto at = [&](double x) {
      return static_cast<double>(heights(static_cast<int>(std::lround(f.column(x))), size / 2));
    };
    EXPECT_EQ(at(0), 10.0F);
    EXPECT_NEAR((at(320) - at(400)) / 80.0, 0.045, 0.015) << size;
    for (double x = 320; x < 980; x += 20) EXPECT_LE(at(x + 20), at(x) + 1e-3) << size << " " << x;
    // Whatever the cell size, the same floor.
    EXPECT_NEAR(at(900), -8.5, 4.0) << size;
  }
}

TEST(Extrapolation, BendsEvenly) {
  Grid<uint8_t> covered;
  HeightField heights = island(256, covered);
  extrapolate_ground(heights, covered, 0.05, {});
  // laplace(u) is the same everywhere but beside what is known.
  double low = 1e9, high = -1e9;
  for (int y = 2; y < 254; ++y) {
    for (int x = 2; x < 254; ++x) {
      if (std::hypot(heights.frame().x(x), heights.frame().y(y)) < 360) continue;
      const double bend = static_cast<double>(heights(x - 1, y)) + static_cast<double>(heights(x + 1, y)) +
                          static_cast<double>(heights(x, y - 1)) + static_cast<double>(heights(x, y + 1)) -
                          4.0 * static_cast<double>(heights(x, y));
      low = std::min(low, bend);
      high = std::max(high, bend);
    }
  }
  EXPECT_GT(low, 0.0);
  EXPECT_LT(high, 2.0 * low);
}

TEST(Extrapolation, NothingKnownIsSaid) {
  HeightField heights(GridFrame::centred(5, 4, 1), 0.0F);
  EXPECT_THROW(extrapolate_ground(heights, Grid<uint8_t>(heights.frame(), uint8_t{0}), 0.05, {}), IncompatibleInputs);
}

}  // namespace
}  // namespace seamount::geom
