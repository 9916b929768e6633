#include "seamount/geom/grid/halve_cells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/rng.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::geom {
namespace {

Grid<float> hills(int width, int height, uint64_t seed) {
  Grid<float> grid = fbm_grid(GridFrame::centred(width, height, 30.0), Seed{seed}, {.wavelength_m = 400.0}, {});
  for (float& z : grid.cells()) z = 900.0F * z + 1000.0F;
  return grid;
}

Grid<float> halved(const Grid<float>& grid, const Grid<uint8_t>* level = nullptr) {
  Grid<float> fine(halved_frame(grid.frame()), 0.0F);
  add_halved_cells(grid, level, fine, {});
  return fine;
}

TEST(HalveCells, KeepsTheMeanOfEachCell) {
  for (const auto& [width, height] : {std::pair{40, 33}, {1, 1}, {1, 9}, {7, 2}, {3, 3}}) {
    for (const uint64_t seed : {1, 2, 3}) {
      const Grid<float> grid = hills(width, height, seed), means = means_of_four(halved(grid), {});
      ASSERT_EQ(means.frame(), grid.frame());
      for (size_t i = 0; i < grid.size(); ++i) ASSERT_NEAR(means.data()[i], grid.data()[i], 5e-4) << width;
    }
  }
}

TEST(HalveCells, APlaneStaysAPlane) {
  Grid<float> grid(GridFrame::centred(20, 14, 30.0));
  for (int y = 0; y < 14; ++y)
    for (int x = 0; x < 20; ++x) grid(x, y) = 3.0F * static_cast<float>(x) - 7.0F * static_cast<float>(y);
  const Grid<float> fine = halved(grid);
  for (int y = 0; y < 28; ++y) {
    for (int x = 0; x < 40; ++x) {
      const double wanted = 3.0 * (0.5 * x - 0.25) - 7.0 * (0.5 * y - 0.25);
      ASSERT_NEAR(fine(x, y), wanted, 2e-4) << x << " " << y;
    }
  }
}

/// Means of a smooth wave over fine cells, from means over coarse ones: nearer than an interpolation that takes means
/// for samples.
TEST(HalveCells, KnowsThatCellsAreMeans) {
  const auto wave = [](double x) { return 100.0 * std::sin(x / 1.6); };
  const auto mean = [](double begin, double end) {
    return -160.0 * (std::cos(end / 1.6) - std::cos(begin / 1.6)) / (end - begin);
  };
  Grid<float> grid(GridFrame::centred(64, 1, 1.0));
  for (int x = 0; x < 64; ++x) grid(x, 0) = static_cast<float>(mean(x, x + 1.0));
  const Grid<float> fine = halved(grid);
  double off = 0.0, off_as_samples = 0.0;
  for (int x = 12; x < 116; ++x) {
    off = std::max(off, std::abs(fine(x, 0) - mean(0.5 * x, 0.5 * x + 0.5)));
    off_as_samples = std::max(off_as_samples,
                              std::abs(wave(0.5 * x + 0.25) * mean(0, 1) / wave(0.5) - mean(0.5 * x, 0.5 * x + 0.5)));
  }
  EXPECT_LT(off, 0.25);
  EXPECT_GT(off_as_samples, 1.0);
}

TEST(HalveCells, LevelCellsAreLevelAndTheirNeighboursBeginThere) {
  Grid<float> grid = hills(24, 24, 5);
  for (int y = 6; y < 16; ++y)
    for (int x = 6; x < 16; ++x) grid(x, y) = 700.0F;
  const Grid<uint8_t> level = level_cells(grid, {});
  EXPECT_EQ(level(6, 6), 0) << "a shore";
  EXPECT_EQ(level(7, 7), 1);
  EXPECT_EQ(level(0, 0), 0);
  const Grid<float> fine = halved(grid, &level);
  for (int y = 14; y < 30; ++y)
    for (int x = 14; x < 30; ++x) ASSERT_EQ(fine(x, y), 700.0F) << x << " " << y;
  const Grid<float> means = means_of_four(fine, {});
  for (size_t i = 0; i < grid.size(); ++i) ASSERT_NEAR(means.data()[i], grid.data()[i], 5e-4);
}

TEST(HalveCells, DoesNotDependOnThreads) {
  const Grid<float> grid = hills(300, 500, 4);
  Grid<float> one(halved_frame(grid.frame()), 0.0F), two = one;
  add_halved_cells(grid, nullptr, one, {.threads = 1});
  add_halved_cells(grid, nullptr, two, {.threads = 2});
  EXPECT_TRUE(one == two);
}

}  // namespace
}  // namespace seamount::geom
