#include "seamount/ops/learned/sketch_level.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "seamount/geom/scalar/noise.h"

namespace seamount::learned {
namespace {

/// A disk of high ground; of a strip in the west nothing is said.
SketchMap disk() {
  SketchMap map;
  map.frame = GridFrame::centred(96, 80, 40);
  map.low_m = 200;
  map.relief_m = 1000;
  map.level = Grid<int8_t>(map.frame, -1);
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 96; ++x) map.level(x, y) = std::hypot(x - 60, y - 40) < 22 ? 1 : x < 10 ? 0 : -1;
  return map;
}

HeightField rough(const GridFrame& frame, uint64_t seed) {
  HeightField z = geom::fbm_grid(frame, Seed{seed}, {.wavelength_m = 1000, .octaves = 6}, {});
  for (float& h : z.cells()) h = 550 + 300 * h;
  return z;
}

double mean_around(const HeightField& z, int x, int y) {
  double sum = 0;
  for (int v = y - 5; v <= y + 5; ++v)
    for (int u = x - 5; u <= x + 5; ++u) sum += z(u, v);
  return sum / 121;
}

TEST(SketchLevel, HighGroundRisesOverLowGround) {
  const SketchMap map = disk();
  for (const uint64_t seed : {1, 2, 3, 4}) {
    const HeightField before = rough(map.frame, seed);
    HeightField made = before;
    meet_level(map, 1, made, {});
    // 0.6 less half of a share of about 0.22, plus and less 0.18 tanh(d / 14), of 1000 m over 200 m.
    EXPECT_GT(mean_around(made, 60, 40), 690 + 90) << seed;
    for (const auto& [x, y] : {std::pair{25, 40}, {25, 70}, {88, 8}, {20, 8}})
      EXPECT_LT(mean_around(made, x, y), 690 - 70) << x << ' ' << y;
    for (int y = 1; y < 79; ++y) {
      for (int x = 1; x < 95; ++x) {
        const auto by = [&](int u) { return made(u, y) - before(u, y); };
        ASSERT_LT(std::abs(by(x) - 0.5F * (by(x - 1) + by(x + 1))), 3) << "detail stays";
      }
    }
    HeightField half = before;
    meet_level(map, 0.5, half, {});
    EXPECT_NEAR(half(60, 40) - before(60, 40), 0.5F * (made(60, 40) - before(60, 40)), 1e-2);
  }
}

TEST(SketchLevel, WhatIsOnItsSideStays) {
  const SketchMap map = disk();
  HeightField made(map.frame);
  for (size_t i = 0; i < made.size(); ++i) made.data()[i] = 690.0F + 900.0F * static_cast<float>(map.level.data()[i]);
  const HeightField before = made;
  meet_level(map, 1, made, {});
  EXPECT_NEAR(made(60, 40), before(60, 40), 1e-3);
  EXPECT_NEAR(made(20, 10), before(20, 10), 1e-3);
}

TEST(SketchLevel, OneSideAloneAndNoAdherenceChangeNothing) {
  for (const int side : {0, 1, -1}) {
    SketchMap map = disk();
    map.level = Grid<int8_t>(map.frame, static_cast<int8_t>(side));
    HeightField heights = rough(map.frame, 5);
    const HeightField before = heights;
    meet_level(map, 1, heights, {});
    EXPECT_EQ(heights, before);
    meet_level(disk(), 0, heights, {});
    EXPECT_EQ(heights, before);
  }
}

}  // namespace
}  // namespace seamount::learned
