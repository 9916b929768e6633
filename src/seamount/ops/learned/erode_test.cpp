#include "seamount/ops/learned/erode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/learned/erode_planes.h"
#include "seamount/ops/learned/test_network.h"

namespace seamount::learned {
namespace {

/// Random weights: laws must hold whatever a network says. `size`: of its plane, in units of change.
Network network_of(int planes, float size = 0.3F) {
  Weights weights = random_weights({planes, {8, 16, 24}}, 1);
  for (float& w : weights.tensors["outer.weight"].values) w *= size;
  return Network(weights, Precision::f32);
}

HeightField hills(const GridFrame& frame, uint64_t seed = 4) {
  HeightField z =
      geom::fbm_grid(frame, Seed{seed}, {.wavelength_m = 30 * frame.cell_m, .octaves = 6, .cell_m = frame.cell_m}, {});
  for (float& h : z.cells()) h = static_cast<float>(8 * frame.cell_m) * h + 500;
  return z;
}

float relief(const HeightField& z) {
  const auto [low, high] = std::minmax_element(z.cells().begin(), z.cells().end());
  return *high - *low;
}

TEST(LearnedErode, LevelGroundAndNoYearsChangeNothing) {
  const Network network = network_of(kErodePlanes, 30);
  const HeightField level(GridFrame::centred(70, 50, 20), 37.5F);
  EXPECT_EQ(erode(level, nullptr, {}, network, {}), level);
  const HeightField ground = hills(GridFrame::centred(70, 50, 20));
  EXPECT_NE(erode(ground, nullptr, {}, network, {}), ground);
  ErodeParams params;
  params.years = 0;
  EXPECT_EQ(erode(ground, nullptr, params, network, {}), ground);
  params = {};
  params.strength = 0;
  EXPECT_EQ(erode(ground, nullptr, params, network, {}), ground);
  // Few years change little, however loud the network is.
  double change = 1e9;
  for (const double years : {1000.0, 100.0, 1.0}) {
    params = {};
    params.years = years;
    const HeightField made = erode(ground, nullptr, params, network_of(kErodePlanes), {});
    double now = 0;
    for (size_t i = 0; i < made.size(); ++i) now += std::abs(made.data()[i] - ground.data()[i]);
    EXPECT_LT(now, change);
    change = now;
  }
  EXPECT_LT(change / static_cast<double>(ground.size()), 0.05);
}

TEST(LearnedErode, StaysWithinTheGroundAroundHoweverOften) {
  for (const float size : {0.3F, 50.0F}) {
    const Network network = network_of(kErodePlanes, size);
    for (const auto& [width, height] : {std::pair{80, 60}, {1, 1}, {1, 40}, {33, 2}}) {
      HeightField ground = hills(GridFrame::centred(width, height, 30));
      float last = relief(ground);
      ErodeParams params;
      params.years = 100000;
      for (int i = 0; i < 20; ++i) {
        ground = erode(ground, nullptr, params, network, {});
        for (const float z : ground.cells()) ASSERT_TRUE(std::isfinite(z));
        ASSERT_LE(relief(ground), last) << "round " << i << " of " << width << " x " << height;
        last = relief(ground);
      }
    }
  }
}

TEST(LearnedErode, TheNetworkMakesNoGround) {
  for (const uint64_t seed : {4, 5, 6}) {
    const HeightField ground = hills(GridFrame::centred(128, 96, 30), seed);
    ErodeParams params;
    params.sea_m = -1000;
    const HeightField made = erode(ground, nullptr, params, network_of(kErodePlanes), {});
    const ErodePlanes planes(ground, params.years, params.sea_m, {});
    double change = 0, estimate = 0, size = 0;
    for (size_t i = 0; i < ground.size(); ++i) {
      change += made.data()[i] - ground.data()[i];
      estimate += planes.unit_m() * planes.base().data()[i];
      size += std::abs(made.data()[i] - ground.data()[i]);
    }
    EXPECT_NEAR(change, estimate, 0.01 * size) << seed;
  }
}

TEST(LearnedErode, TheMaskIsAShareOfTheChange) {
  const Network network = network_of(kErodePlanes);
  const HeightField ground = hills(GridFrame::centred(64, 64, 40));
  const HeightField whole = erode(ground, nullptr, {}, network, {});
  Mask mask(ground.frame(), 0.0F);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) mask(x, y) = x < 20 ? -0.5F : x < 40 ? 0.5F : 7.0F;
  }
  const HeightField part = erode(ground, &mask, {}, network, {});
  ErodeParams half;
  half.strength = 0.5;
  const HeightField halved = erode(ground, nullptr, half, network, {});
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      if (x < 20) {
        ASSERT_EQ(part(x, y), ground(x, y));
      } else {
        ASSERT_EQ(part(x, y), x < 40 ? halved(x, y) : whole(x, y));
      }
    }
  }
}

TEST(LearnedErode, ThreadsDoNotCount) {
  const Network network = network_of(kErodePlanes);
  const HeightField ground = hills(GridFrame::centred(300, 270, 25));
  RunContext one;
  one.threads = 1;
  EXPECT_EQ(erode(ground, nullptr, {}, network, one), erode(ground, nullptr, {}, network, {}));
}

TEST(LearnedErode, RefusesWhatDoesNotFit) {
  HeightField ground = hills(GridFrame::centred(40, 30, 25));
  const Network network = network_of(kErodePlanes);
  const Mask other(GridFrame::centred(30, 40, 25), 1.0F);
  EXPECT_THROW(erode(ground, &other, {}, network, {}), IncompatibleInputs);
  EXPECT_THROW(erode(ground, nullptr, {}, network_of(kErodePlanes - 1), {}), InvalidArgument);
  ErodeParams params;
  params.years = -1;
  EXPECT_THROW(erode(ground, nullptr, params, network, {}), InvalidArgument);
  ground(3, 4) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(erode(ground, nullptr, {}, network, {}), InvalidArgument);
}

TEST(ErodePlanes, AreOfOneSizeForAllReliefsAndYears) {
  for (const double cell : {10.0, 90.0}) {
    for (const double years : {1.0, 1000.0, 300000.0}) {
      const HeightField ground = hills(GridFrame::centred(96, 64, cell));
      const ErodePlanes erode(ground, years, 0, {});
      ASSERT_GT(erode.unit_m(), 0);
      std::vector<float> values(ground.size() * kErodePlanes);
      erode.planes().fill(0, ground.height(), values);
      for (size_t i = 0; i < values.size(); ++i) {
        ASSERT_TRUE(std::isfinite(values[i]));
        ASSERT_LT(std::abs(values[i]), years < 10 ? 16 : 9) << "plane " << i % kErodePlanes;
      }
      double mean = 0;
      for (const float dz : erode.base().cells()) mean += std::abs(dz);
      EXPECT_NEAR(mean / static_cast<double>(ground.size()), 1, 1e-3);
    }
  }
}

}  // namespace
}  // namespace seamount::learned
