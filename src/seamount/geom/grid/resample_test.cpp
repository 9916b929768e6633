#include "seamount/geom/grid/resample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::geom {
namespace {

ScalarField random_field(int width, int height, uint64_t seed) {
  ScalarField field({width, height, 2.0, 100, 50, {}});
  Rng rng(Seed{seed});
  for (float& v : field.cells()) v = static_cast<float>(rng.uniform(-10, 10));
  return field;
}

double mean(const Grid<float>& grid) {
  double sum = 0;
  for (const float v : grid.cells()) sum += static_cast<double>(v);
  return sum / static_cast<double>(grid.size());
}

TEST(Sample, ReproducesPlanesAndSamples) {
  ScalarField plane({20, 30, 1, 0, 0, {}});
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 20; ++x) plane(x, y) = static_cast<float>(3 * x - 2 * y + 1);
  }
  const ScalarField noise = random_field(20, 30, 1);
  for (double x = 2; x < 17; x += 0.37) {
    for (double y = 2; y < 27; y += 0.41) {
      EXPECT_NEAR(sample_bilinear(plane, x, y), 3 * x - 2 * y + 1, 1e-4);
      EXPECT_NEAR(sample_bicubic(plane, x, y), 3 * x - 2 * y + 1, 1e-4);
      EXPECT_NEAR(sample_bspline(plane, x, y), 3 * x - 2 * y + 1, 1e-4);
      EXPECT_LE(std::abs(sample_bspline(noise, x, y)), 10.0F);
    }
  }
  EXPECT_EQ(sample_bilinear(noise, 4, 7), noise(4, 7));
  EXPECT_EQ(sample_bicubic(noise, 4, 7), noise(4, 7));
  EXPECT_EQ(sample_bilinear(noise, -9e9, 1e9), noise(0, 29));
  EXPECT_EQ(sample_bicubic(random_field(1, 1, 3), 5, -4), random_field(1, 1, 3)(0, 0));
}

TEST(Resample, IsTheIdentityOnItsOwnFrame) {
  const ScalarField field = random_field(13, 7, 2);
  EXPECT_EQ(resample(field, field.frame(), {}), field);
  EXPECT_EQ(box_downsample(field, 1, {}), field);
}

TEST(Resample, FinerAgreesWithTheBicubicSampler) {
  const ScalarField field = random_field(13, 7, 2);
  GridFrame finer = field.frame();
  finer.width = 31;
  finer.height = 17;
  finer.cell_m = 0.83;
  const ScalarField result = resample(field, finer, {});
  for (int y = 0; y < finer.height; ++y) {
    for (int x = 0; x < finer.width; ++x) {
      EXPECT_NEAR(result(x, y), sample_bicubic(field, field.frame().column(finer.x(x)), field.frame().row(finer.y(y))),
                  1e-4);
    }
  }
}

TEST(Resample, CoarserAverages) {
  const ScalarField field = random_field(12, 8, 4);
  const Grid<float> half = box_downsample(field, 4, {});
  ASSERT_EQ(half.width(), 3);
  double sum = 0;
  for (int y = 4; y < 8; ++y) {
    for (int x = 8; x < 12; ++x) sum += static_cast<double>(field(x, y));
  }
  EXPECT_NEAR(half(2, 1), sum / 16, 1e-5);
  EXPECT_NEAR(mean(half), mean(field), 1e-5);
  GridFrame odd = field.frame();
  odd.width = 5;
  odd.height = 3;
  odd.cell_m = 2.0 * 12 / 5;
  EXPECT_NEAR(mean(resample(ScalarField(field.frame(), 7.0F), odd, {})), 7.0, 1e-5);
  EXPECT_THROW(box_downsample(field, 5, {}), InvalidArgument);
  EXPECT_THROW(box_downsample(field, 0, {}), InvalidArgument);
}

TEST(ResampleLabels, TakesTheNearestOrTheMostFrequent) {
  Grid<uint8_t> labels({4, 4, 1, 0, 4, {}}, uint8_t{1});
  labels(0, 0) = labels(1, 0) = labels(0, 1) = 3;
  const Grid<uint8_t> coarse = resample_labels(labels, {2, 2, 2, 0, 4, {}}, {});
  EXPECT_EQ(coarse(0, 0), 3);
  EXPECT_EQ(coarse(1, 0), 1);
  const Grid<uint8_t> fine = resample_labels(labels, {8, 8, 0.5, 0, 4, {}}, {});
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) EXPECT_EQ(fine(x, y), labels(x / 2, y / 2));
  }
  EXPECT_EQ(resample_labels(labels, labels.frame(), {}), labels);
}

TEST(GaussianBlur, IsCloseToTheGaussian) {
  for (const double sigma : {0.7, 2.0, 6.3}) {
    ScalarField field({81, 81, 2.0, 0, 0, {}}, 0.0F);
    field(40, 40) = 1.0F;
    gaussian_blur(field, sigma * 2.0, {});
    double variance = 0, sum = 0;
    for (int y = 0; y < 81; ++y) {
      for (int x = 0; x < 81; ++x) {
        const double value = static_cast<double>(field(x, y));
        variance += value * (x - 40) * (x - 40);
        sum += value;
        if (sigma < 1) continue;
        const double r2 = (x - 40) * (x - 40) + (y - 40) * (y - 40);
        EXPECT_NEAR(value, std::exp(-r2 / (2 * sigma * sigma)) / (2 * std::numbers::pi * sigma * sigma),
                    0.13 / (2 * std::numbers::pi * sigma * sigma));
      }
    }
    EXPECT_NEAR(sum, 1.0, 1e-5);
    EXPECT_NEAR(variance, sigma * sigma, 1e-3 * sigma * sigma + 1e-4);
    EXPECT_NEAR(field(43, 40), field(40, 37), 1e-7);
  }
}

TEST(GaussianBlur, KeepsTheMeanOnAnyShapeForAnySigma) {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 33}, {33, 1}, {17, 29}, {100, 9}}) {
    for (const double sigma : {0.0, 0.1, 3.0, 50.0, 1e7}) {
      ScalarField field = random_field(width, height, 8);
      const double before = mean(field);
      gaussian_blur(field, sigma, {});
      EXPECT_NEAR(mean(field), before, 1e-4) << width << ' ' << height << ' ' << sigma;
    }
  }
  ScalarField field = random_field(3, 3, 1);
  EXPECT_THROW(gaussian_blur(field, -1, {}), InvalidArgument);
}

TEST(GaussianBlur, IsTheSameOnAnyNumberOfThreads) {
  RunContext one, four;
  one.threads = 1;
  four.threads = 4;
  ScalarField a = random_field(700, 301, 5), b = a;
  gaussian_blur(a, 9, one);
  gaussian_blur(b, 9, four);
  EXPECT_EQ(a, b);
}

}  // namespace
}  // namespace seamount::geom
