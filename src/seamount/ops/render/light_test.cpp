#include "seamount/ops/render/light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace seamount::render {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

TEST(SunVisibility, ATowersShadowIsAsLongAsTheSunIsLow) {
  // A wall 20 m high along a column, the sun in the west at 45 degrees: 20 m of shadow to the east of it.
  HeightField terrain(GridFrame::centred(101, 61, 1.0), 0.0F);
  for (int y = 0; y < 61; ++y) terrain(40, y) = 20.0F;
  const Grid<float> lit = sun_visibility(terrain, {270.0 * kDegree, 45.0 * kDegree}, 0.005, {});
  EXPECT_NEAR(lit(20, 30), 1.0F, 1e-5F);
  EXPECT_NEAR(lit(50, 30), 0.0F, 1e-5F);
  EXPECT_NEAR(lit(58, 30), 0.0F, 1e-5F);
  EXPECT_NEAR(lit(63, 30), 1.0F, 1e-5F);
}

/// Independent and slow: walks from each cell towards the sun.
bool in_sun(const HeightField& terrain, int x, int y, double azimuth, double elevation) {
  const double dx = std::sin(azimuth), dy = -std::cos(azimuth), rise = std::tan(elevation) * terrain.cell_m();
  for (double s = 1.0; s < 200.0; s += 0.25) {
    const int cx = static_cast<int>(std::lround(x + s * dx)), cy = static_cast<int>(std::lround(y + s * dy));
    if (!terrain.contains(cx, cy)) break;
    if (terrain(cx, cy) > terrain(x, y) + s * rise) return false;
  }
  return true;
}

TEST(SunVisibility, AgreesWithWalkingTowardsTheSunFromAnyBearing) {
  HeightField terrain(GridFrame::centred(70, 50, 10.0), 0.0F);
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 70; ++x) {
      terrain(x, y) = 90.0F * static_cast<float>(std::exp(-(std::pow(x - 35.0, 2) + std::pow(y - 25.0, 2)) / 60.0));
    }
  }
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += 33.0) {
    const Grid<float> lit = sun_visibility(terrain, {azimuth * kDegree, 20.0 * kDegree}, 0.01, {});
    int wrong = 0;
    for (int y = 0; y < 50; ++y) {
      for (int x = 0; x < 70; ++x) {
        if (std::abs(lit(x, y) - 0.5F) < 0.49F) continue;  // the shadow's soft edge
        wrong += (lit(x, y) > 0.5F) != in_sun(terrain, x, y, azimuth * kDegree, 20.0 * kDegree) ? 1 : 0;
      }
    }
    EXPECT_LE(wrong, 35) << azimuth;  // one per cent: the walk rounds to cells
  }
}

TEST(SunVisibility, DoesNotDependOnThreads) {
  HeightField terrain(GridFrame::centred(1300, 90, 10.0), 0.0F);
  for (size_t i = 0; i < terrain.size(); ++i) terrain.cells()[i] = static_cast<float>((i * 7919) % 97);
  EXPECT_EQ(sun_visibility(terrain, {0.3, 0.4}, 0.01, {.threads = 1}),
            sun_visibility(terrain, {0.3, 0.4}, 0.01, {.threads = 2}));
}

TEST(Openness, ThePlainSeesAllAndThePitLess) {
  HeightField terrain(GridFrame::centred(65, 65, 10.0), 0.0F);
  terrain(32, 32) = -40.0F;
  const Openness open = openness(terrain, {});
  EXPECT_FLOAT_EQ(open.sky(5, 5), 1.0F);
  EXPECT_LT(open.sky(32, 32), 0.35F);
  EXPECT_GT(open.concavity(32, 32), 0.0F);
}

TEST(Light, OddShapesAreFine) {
  for (const auto& [w, h] : {std::pair{1, 1}, {1, 7}, {9, 1}, {3, 2}}) {
    const HeightField terrain(GridFrame::centred(w, h, 5.0), 3.0F);
    const Grid<float> lit = sun_visibility(terrain, {1.0, 0.5}, 0.01, {});
    const Openness open = openness(terrain, {});
    for (const float v : lit.cells()) EXPECT_NEAR(v, 1.0F, 1e-5F);
    for (const float v : open.sky.cells()) EXPECT_NEAR(v, 1.0F, 1e-5F);
  }
}

TEST(Reduce, KeepsMeansAndHalvesUntilItFits) {
  HeightField terrain(GridFrame::centred(8, 4, 10.0));
  for (size_t i = 0; i < terrain.size(); ++i) terrain.cells()[i] = static_cast<float>(i);
  const HeightField half = reduce(terrain, 4, {});
  EXPECT_EQ(half.width(), 4);
  EXPECT_EQ(half.height(), 2);
  EXPECT_DOUBLE_EQ(half.cell_m(), 20.0);
  EXPECT_FLOAT_EQ(half(0, 0), 4.5F);
  EXPECT_EQ(reduce(terrain, 8, {}), terrain);
}

}  // namespace
}  // namespace seamount::render
