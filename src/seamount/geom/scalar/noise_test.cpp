#include "seamount/geom/scalar/noise.h"

#include "seamount/geom/scalar/noise_places.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "seamount/geom/grid/resample.h"

namespace seamount::geom {
namespace {

struct Moments {
  double mean = 0, deviation = 0, largest = 0;
};

template <class Values>
Moments moments(const Values& values) {
  Moments m;
  double squares = 0;
  for (const double v : values) {
    m.mean += v;
    squares += v * v;
    m.largest = std::max(m.largest, std::abs(v));
  }
  m.mean /= static_cast<double>(values.size());
  m.deviation = std::sqrt(squares / static_cast<double>(values.size()) - m.mean * m.mean);
  return m;
}

TEST(Perlin, IsZeroAtLatticePointsSmoothAndBounded) {
  std::vector<double> values;
  for (int j = 0; j < 300; ++j) {
    for (int i = 0; i < 300; ++i) values.push_back(perlin(Seed{1}, i * 0.377 - 50, j * 0.391 + 9));
    EXPECT_EQ(perlin(Seed{1}, j - 150, 3 * j), 0.0);
    const double x = 0.137 * j, h = 1e-5;
    EXPECT_LT(std::abs(perlin(Seed{1}, x + h, 5.3) - perlin(Seed{1}, x, 5.3)), 4 * h);
  }
  const Moments m = moments(values);
  EXPECT_NEAR(m.mean, 0.0, 0.01);
  EXPECT_NEAR(m.deviation, 0.32, 0.05);
  EXPECT_LE(m.largest, 1.0);
  EXPECT_GT(m.largest, 0.8);
}

TEST(Perlin, DependsOnTheSeedAndDoesNotRepeat) {
  int same_seed = 0, same_shift = 0;
  for (int i = 0; i < 1000; ++i) {
    const double x = i * 0.71 + 0.3;
    same_seed += std::abs(perlin(Seed{1}, x, 0.5) - perlin(Seed{2}, x, 0.5)) < 1e-3;
    same_shift += std::abs(perlin(Seed{1}, x, 0.5) - perlin(Seed{1}, x + 256, 0.5)) < 1e-3;
  }
  EXPECT_LT(same_seed, 20);
  EXPECT_LT(same_shift, 20);
}

TEST(Fbm, RowsAgreeWithThePlainFormNearAndFarFromTheOrigin) {
  const Fbm shape = {.wavelength_m = 1300.0, .octaves = 8};
  for (const double origin : {0.0, -3e4, 7e6, -4e8}) {
    for (const size_t count : {size_t{1}, size_t{63}, size_t{64}, size_t{65}, size_t{1000}}) {
      std::vector<float> row(count), ridges(count), sum(count, 2.0F);
      fbm_row(Seed{3}, shape, origin, 7.3, origin * 0.7 + 11, row);
      ridged_row(Seed{3}, shape, origin, 7.3, origin * 0.7 + 11, ridges);
      fbm_add_row(Seed{3}, shape, origin, 7.3, origin * 0.7 + 11, sum, 10.0F);
      for (size_t i = 0; i < count; i += 7) {
        const double x = origin + static_cast<double>(i) * 7.3, y = origin * 0.7 + 11;
        ASSERT_NEAR(row[i], fbm(Seed{3}, shape, x, y), 1e-5);
        ASSERT_NEAR(ridges[i], ridged(Seed{3}, shape, x, y), 1e-5);
        ASSERT_NEAR(sum[i], 2.0F + 10.0F * row[i], 1e-5);
      }
    }
  }
}

TEST(Fbm, PlacesAreThePlainFormToTheBit) {
  const Fbm shape{.wavelength_m = 130.0, .octaves = 5, .gain = 0.45};
  const std::vector<Vec2> places = {{0, 0}, {1.5, -7e5}, {-33.25, 812}, {4e6, 1}};
  std::vector<double> out(places.size());
  fbm_places(Seed{7}, shape, places, out);
  for (size_t i = 0; i < places.size(); ++i) EXPECT_EQ(out[i], fbm(Seed{7}, shape, places[i].x, places[i].y));
}

TEST(Fbm, IsAboutBetweenMinusOneAndOne) {
  const ScalarField field = fbm_grid(GridFrame::centred(512, 512, 50), Seed{5}, {.wavelength_m = 700}, {});
  const Moments m = moments(field.cells());
  EXPECT_NEAR(m.mean, 0.0, 0.03);
  EXPECT_NEAR(m.deviation, 0.32, 0.05);
  EXPECT_LT(m.largest, 1.6);
  const ScalarField ridges = ridged_grid(GridFrame::centred(512, 512, 50), Seed{5}, {.wavelength_m = 700}, {});
  for (const float v : ridges.cells()) {
    ASSERT_GE(v, 0.0F);
    ASSERT_LE(v, 1.0F);
  }
}

TEST(Fbm, HasNoPreferredDirection) {
  // Mean squared differences over one step in twelve directions agree.
  std::vector<double> energy;
  for (int k = 0; k < 12; ++k) {
    const double angle = k * std::numbers::pi / 12, step = 130;
    double sum = 0;
    for (int i = 0; i < 8000; ++i) {
      const double x = std::fmod(i * 733.7, 90000), y = i * 117.3;
      const Fbm shape = {.wavelength_m = 1000, .octaves = 4};
      const double d =
          fbm(Seed{8}, shape, x + step * std::cos(angle), y + step * std::sin(angle)) - fbm(Seed{8}, shape, x, y);
      sum += d * d;
    }
    energy.push_back(sum);
  }
  const Moments m = moments(energy);
  EXPECT_LT(m.deviation / m.mean, 0.1);
}

TEST(Fbm, GridIsTheSameOnAnyNumberOfThreadsAndInAnyWindow) {
  GridFrame frame = {333, 201, 10.0, 5000.0, -700.0, {}};
  const Fbm shape = {.wavelength_m = 900};
  RunContext one, four;
  one.threads = 1;
  four.threads = 4;
  EXPECT_EQ(fbm_grid(frame, Seed{1}, shape, one), fbm_grid(frame, Seed{1}, shape, four));
  const ScalarField field = fbm_grid(frame, Seed{1}, shape, one);
  EXPECT_NEAR(field(200, 100), fbm(Seed{1}, shape, frame.x(200), frame.y(100)), 1e-5);
  EXPECT_EQ(fbm_grid({1, 1, 10, 0, 0, {}}, Seed{1}, shape, one).size(), 1U);
}

TEST(Fbm, CoarseGridIsTheAverageOfAFineOne) {
  const auto grid = [](int size) {
    const GridFrame frame = GridFrame::centred(size, size, 20480.0 / size);
    return fbm_grid(frame, Seed{4}, {.wavelength_m = 4000, .octaves = 10, .cell_m = frame.cell_m}, {});
  };
  const ScalarField coarse = grid(128);
  const ScalarField averaged = box_downsample(grid(1024), 8, {});
  std::vector<double> errors;
  for (size_t i = 0; i < coarse.size(); ++i) errors.push_back(coarse.cells()[i] - averaged.cells()[i]);
  EXPECT_LT(moments(errors).deviation, 0.01);
  EXPECT_NEAR(octave_weight(1000, 10), 1.0, 1e-3);
  EXPECT_EQ(octave_weight(10, 10), 0.0);
  EXPECT_EQ(octave_weight(10, 0), 1.0);
}

TEST(Fbm1, IsSmoothAndBounded) {
  std::vector<double> values;
  for (int i = 0; i < 5000; ++i) {
    const double x = i * 0.0937 - 200;
    values.push_back(fbm1(Seed{2}, x, 5));
    EXPECT_LT(std::abs(fbm1(Seed{2}, x + 1e-6, 5) - values.back()), 1e-4);
  }
  const Moments m = moments(values);
  EXPECT_NEAR(m.mean, 0.0, 0.06);
  EXPECT_NEAR(m.deviation, 0.35, 0.1);
}

TEST(FbmCircle, ClosesWithoutASeam) {
  const double turn = 2 * std::numbers::pi;
  for (const double frequency : {0.5, 3.0, 20.0}) {
    EXPECT_NEAR(fbm_circle(Seed{2}, 0.7, frequency, 5), fbm_circle(Seed{2}, 0.7 + turn, frequency, 5), 1e-9);
    EXPECT_NEAR(fbm_circle(Seed{2}, turn - 1e-7, frequency, 5), fbm_circle(Seed{2}, 1e-7, frequency, 5), 1e-4);
  }
}

}  // namespace
}  // namespace seamount::geom
