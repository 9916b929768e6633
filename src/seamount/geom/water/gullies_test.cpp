#include "seamount/geom/water/gullies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::geom {
namespace {

HeightField island(int size) {
  const GridFrame frame = GridFrame::centred(size, size, 20480.0 / size);
  HeightField height = fbm_grid(frame, Seed{7}, {.wavelength_m = 9000, .octaves = 3}, {});
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double r = std::hypot(frame.x(x), frame.y(y));
      const double t = 1 - r * (1 + 0.12 * static_cast<double>(height(x, y))) / 9000;
      height(x, y) = static_cast<float>(2000 * t);
    }
  }
  return height;
}

HeightField carved(const HeightField& base, const Gullies& gullies, uint64_t seed = 7, const RunContext& run = {}) {
  HeightField height = base;
  add_gullies(height, Seed{seed}, gullies, ScalarField(base.frame(), 1.0F), run);
  return height;
}

double deviation(const HeightField& a, const HeightField& b) {
  double sum = 0, squares = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    const double d = static_cast<double>(a.cells()[i]) - static_cast<double>(b.cells()[i]);
    sum += d;
    squares += d * d;
  }
  const double n = static_cast<double>(a.size());
  return std::sqrt(squares / n - sum / n * sum / n);
}

TEST(Gullies, AreRepeatableOnAnyNumberOfThreadsAndDifferBySeed) {
  const HeightField base = island(300);
  RunContext one, four;
  one.threads = 1;
  four.threads = 4;
  EXPECT_EQ(carved(base, {}, 7, one), carved(base, {}, 7, four));
  EXPECT_GT(deviation(carved(base, {}, 7), carved(base, {}, 8)), 5.0);
}

TEST(Gullies, VanishOnFlatsAndWhereTheStrengthIsZero) {
  const HeightField flat(GridFrame::centred(90, 70, 20.0), 100.0F);
  const HeightField still = carved(flat, {});
  for (const float z : still.cells()) EXPECT_NEAR(z, 100.0F, 1e-3);
  const HeightField base = island(128);
  ScalarField strength(base.frame(), 1.0F);
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 40; ++x) strength(x, y) = 0.0F;
  }
  HeightField height = base;
  add_gullies(height, Seed{1}, {.wavelength_m = 1500}, strength, {});
  double west = 0, east = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 20; ++x) west = std::max(west, static_cast<double>(std::abs(height(x, y) - base(x, y))));
    for (int x = 60; x < 128; ++x) east = std::max(east, static_cast<double>(std::abs(height(x, y) - base(x, y))));
  }
  EXPECT_LT(west, 1.0);
  EXPECT_GT(east, 20.0);
}

TEST(Gullies, RunDownTheSlope) {
  // On a plane that falls to the east, heights vary more from north to south than the added part does along the fall.
  const GridFrame frame = GridFrame::centred(256, 256, 20.0);
  HeightField plane(frame);
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) plane(x, y) = static_cast<float>(-0.3 * frame.x(x));
  }
  const HeightField height = carved(plane, {.wavelength_m = 800, .octaves = 1});
  double along = 0, across = 0;
  for (int y = 8; y < 248; ++y) {
    for (int x = 8; x < 248; ++x) {
      along += std::pow(static_cast<double>(height(x + 1, y) - plane(x + 1, y) - height(x, y) + plane(x, y)), 2);
      across += std::pow(static_cast<double>(height(x, y + 1) - height(x, y)), 2);
    }
  }
  EXPECT_GT(across, 6 * along);
}

TEST(Gullies, AreAsDeepAtTheGridsEdgeAsWithin) {
  const GridFrame frame = GridFrame::centred(256, 256, 20.0);
  HeightField plane(frame);
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) plane(x, y) = static_cast<float>(0.2 * frame.x(x) + 0.25 * frame.y(y));
  }
  double edge = 0, within = 0;
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    const HeightField height = carved(plane, {.wavelength_m = 600, .octaves = 4}, seed);
    for (int i = 0; i < 256; ++i) {
      for (const auto& [x, y] : {std::pair(0, i), {255, i}, {i, 0}, {i, 255}})
        edge += std::pow(height(x, y) - plane(x, y), 2);
      for (const auto& [x, y] : {std::pair(64, i), {190, i}, {i, 64}, {i, 190}})
        within += std::pow(height(x, y) - plane(x, y), 2);
    }
  }
  EXPECT_NEAR(edge / within, 1.0, 0.25);
}

TEST(Gullies, LeaveFewPitsAndNoSpikes) {
  const HeightField height = carved(island(512), {.wavelength_m = 2400, .octaves = 7});
  int pits = 0;
  double steepest = 0;
  for (int y = 1; y < 511; ++y) {
    for (int x = 1; x < 511; ++x) {
      bool pit = true;
      for (int k = 0; k < 9; ++k) pit &= k == 4 || height(x + k % 3 - 1, y + k / 3 - 1) > height(x, y);
      pits += pit;
      const double fall = static_cast<double>(std::abs(height(x + 1, y) - height(x, y))) / height.cell_m();
      steepest = std::max(steepest, fall);
    }
  }
  EXPECT_LT(pits, 512 * 512 / 400);
  EXPECT_LT(steepest, 2.5);
}

TEST(Gullies, CoarseGridIsAPreviewOfAFineOne) {
  const Gullies gullies = {.wavelength_m = 3000, .octaves = 7};
  const HeightField coarse_base = island(128), fine_base = island(1024);
  const HeightField coarse = carved(coarse_base, gullies);
  const HeightField fine = box_downsample(carved(fine_base, gullies), 8, {});
  const double added = deviation(fine, box_downsample(fine_base, 8, {}));
  EXPECT_GT(added, 15.0);
  EXPECT_LT(deviation(coarse, fine), 0.15 * added);
}

TEST(Gullies, TakeOddShapesAndRefuseWrongOnes) {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 50}, {200, 3}, {67, 129}}) {
    const GridFrame frame = GridFrame::centred(width, height, 10.0);
    const HeightField base = fbm_grid(frame, Seed{1}, {.wavelength_m = 300}, {});
    const HeightField height_field = carved(base, {});
    for (const float z : height_field.cells()) EXPECT_TRUE(std::isfinite(z));
  }
  HeightField height(GridFrame::centred(8, 8, 1), 0.0F);
  EXPECT_THROW(add_gullies(height, Seed{}, {}, ScalarField(GridFrame::centred(8, 7, 1), 1.0F), {}), IncompatibleInputs);
  EXPECT_THROW(carved(height, {.wavelength_m = 0}), InvalidArgument);
  EXPECT_THROW(carved(height, {.octaves = 0}), InvalidArgument);
  EXPECT_THROW(carved(height, {.gain = 1}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::geom
