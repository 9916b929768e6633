#include "seamount/geom/solve/poisson.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

double largest_laplacian(const ScalarField& u, const Grid<uint8_t>& fixed) {
  double worst = 0;
  for (int y = 0; y < u.height(); ++y) {
    for (int x = 0; x < u.width(); ++x) {
      if (fixed(x, y) != 0) continue;
      double sum = 0;
      for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        if (u.contains(x + dx, y + dy)) sum += static_cast<double>(u(x + dx, y + dy)) - static_cast<double>(u(x, y));
      }
      worst = std::max(worst, std::abs(sum));
    }
  }
  return worst;
}

TEST(Laplace, FindsTheHarmonicFunction) {
  for (const auto& [width, height] : {std::pair(64, 64), {97, 41}, {300, 257}}) {
    const GridFrame frame = GridFrame::centred(width, height, 1.0);
    Grid<uint8_t> fixed(frame, uint8_t{0});
    ScalarField u(frame, 123.0F), exact(frame);
    const double scale = 1.0 / height;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        exact(x, y) = static_cast<float>(std::exp(scale * frame.x(x)) * std::sin(scale * frame.y(y)));
        if (x == 0 || y == 0 || x == width - 1 || y == height - 1) {
          fixed(x, y) = 1;
          u(x, y) = exact(x, y);
        }
      }
    }
    solve_laplace(u, fixed, {}, {.tolerance = 1e-6});
    for (size_t i = 0; i < u.size(); ++i)
      ASSERT_NEAR(u.cells()[i], exact.cells()[i], 2e-3 * std::exp(0.5 * width * scale));
  }
}

TEST(Poisson, OfADiscIsAParaboloid) {
  const GridFrame frame = GridFrame::centred(256, 256, 3.0);
  Grid<uint8_t> fixed(frame);
  const double radius = 350;
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) fixed(x, y) = std::hypot(frame.x(x), frame.y(y)) >= radius ? 1 : 0;
  }
  ScalarField u(frame, 0.0F);
  solve_poisson(u, fixed, ScalarField(frame, -1.0F), {}, {.tolerance = 1e-5});
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) {
      const double r = std::hypot(frame.x(x), frame.y(y));
      const double expected = r < radius ? (radius * radius - r * r) / 4 : 0;
      EXPECT_NEAR(u(x, y), expected, 0.5 * radius * 3.0);  // the border is known to a cell
    }
  }
}

TEST(Laplace, ConvergesForFixedCellsOfAnyShape) {
  Rng rng(Seed{1});
  for (int trial = 0; trial < 24; ++trial) {
    const int width = rng.integer(1, 150), height = rng.integer(1, 150);
    const GridFrame frame = GridFrame::centred(width, height, 10.0);
    Grid<uint8_t> fixed(frame, uint8_t{0});
    ScalarField u(frame, 0.0F);
    const int count = trial % 3 == 0 ? 1 : trial % 3 == 1 ? 40 : width * height / 3;
    for (int i = 0; i < count; ++i) {
      const int x = rng.integer(0, width - 1), y = rng.integer(0, height - 1);
      fixed(x, y) = 1;
      u(x, y) = static_cast<float>(rng.uniform(-100, 100));
    }
    if (trial % 4 == 0) {
      for (int x = 0; x < width; ++x) fixed(x, height / 2) = 1;  // a thin line, 0
    }
    solve_laplace(u, fixed, {}, {.tolerance = 1e-4, .max_cycles = 60});
    EXPECT_LT(largest_laplacian(u, fixed), 0.05) << "trial " << trial << ", " << width << " x " << height;
    for (const float v : u.cells()) EXPECT_LE(std::abs(v), 100.5F);  // maximum principle
  }
}

TEST(Laplace, LeavesFixedCellsAndZeroesWhatIsCutOff) {
  Grid<uint8_t> fixed({5, 1, 1, 0, 0, {}}, uint8_t{0});
  ScalarField u(fixed.frame(), 9.0F);
  fixed(0, 0) = fixed(4, 0) = 1;
  u(4, 0) = 1.0F;
  solve_laplace(u, fixed, {}, {.tolerance = 1e-6});
  EXPECT_EQ(u(0, 0), 9.0F);
  EXPECT_NEAR(u(2, 0), 5.0F, 1e-3);
  ScalarField alone(fixed.frame(), 9.0F);
  solve_laplace(alone, Grid<uint8_t>(fixed.frame(), uint8_t{0}), {});
  for (const float v : alone.cells()) EXPECT_EQ(v, 0.0F);
  EXPECT_THROW(solve_laplace(u, Grid<uint8_t>({4, 1, 1, 0, 0, {}}, uint8_t{0}), {}), IncompatibleInputs);
}

TEST(Laplace, IsTheSameOnAnyNumberOfThreads) {
  const GridFrame frame = GridFrame::centred(500, 400, 1.0);
  Grid<uint8_t> fixed(frame, uint8_t{0});
  ScalarField a(frame, 0.0F);
  Rng rng(Seed{3});
  for (int i = 0; i < 100; ++i) {
    const int x = rng.integer(0, 499), y = rng.integer(0, 399);
    fixed(x, y) = 1;
    a(x, y) = static_cast<float>(rng.uniform());
  }
  ScalarField b = a;
  RunContext one, four;
  one.threads = 1;
  four.threads = 4;
  solve_laplace(a, fixed, one);
  solve_laplace(b, fixed, four);
  EXPECT_EQ(a, b);
}

}  // namespace
}  // namespace seamount::geom
