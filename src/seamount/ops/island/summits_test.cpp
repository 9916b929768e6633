// Lobes, summits and the heights that they end up with.
#include "seamount/ops/island/summits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/ops/island/build.h"

namespace seamount::island {
namespace {

Ring disc(Vec2 centre, double radius) {
  Ring ring;
  for (int i = 0; i < 90; ++i) {
    const double a = 2 * std::numbers::pi * i / 90;
    ring.push_back(centre + radius * Vec2{std::cos(a), std::sin(a)});
  }
  return ring;
}

/// A large island and a smaller one behind an isthmus of 1.6 km, as Tahiti has it, in one ring.
Polygon two_lobes(double large_m, double small_m, double apart_m) {
  constexpr double kHalfNeck = 800.0;
  Polygon land;
  const double a0 = std::asin(kHalfNeck / large_m), b0 = std::asin(kHalfNeck / small_m);
  for (int i = 0; i <= 80; ++i) {
    const double a = a0 + (2 * std::numbers::pi - 2 * a0) * i / 80;
    land.outer.push_back(large_m * Vec2{std::cos(a), std::sin(a)});
  }
  for (int i = 0; i <= 60; ++i) {
    const double a = std::numbers::pi + b0 + (2 * std::numbers::pi - 2 * b0) * i / 60;
    land.outer.push_back(Vec2{apart_m, 0} + small_m * Vec2{std::cos(a), std::sin(a)});
  }
  return land;
}

Plan plan_of(const std::vector<Polygon>& land) { return plan_from_areas({{{"", land}}, {}, {}}, {}, "areas"); }

float highest_near(const HeightField& terrain, Vec2 place, double reach) {
  float highest = -1e9F;
  for (int y = 0; y < terrain.height(); ++y)
    for (int x = 0; x < terrain.width(); ++x)
      if (std::hypot(terrain.frame().x(x) - place.x, terrain.frame().y(y) - place.y) < reach)
        highest = std::max(highest, terrain(x, y));
  return highest;
}

TEST(FindLobes, ADiscIsOneAndADumbBellTwo) {
  const std::vector<Lobe> one = find_lobes({{disc({500, -300}, 2000), {}}});
  ASSERT_EQ(one.size(), 1U);
  EXPECT_NEAR(one[0].radius_m, 2000, 30);
  EXPECT_NEAR(one[0].centre.x, 500, 60);
  EXPECT_NEAR(one[0].centre.y, -300, 60);
  const std::vector<Lobe> two = find_lobes({two_lobes(9000, 4000, 14000)});
  ASSERT_GE(two.size(), 2U);
  EXPECT_NEAR(two[0].radius_m, 9000, 200);
  EXPECT_NEAR(two[1].radius_m, 4000, 200);
  EXPECT_NEAR(two[1].centre.x, 14000, 300);
}

TEST(FindLobes, EveryIslandHasOneHoweverSmallBesideTheOthers) {
  std::vector<Polygon> land = {{disc({0, 0}, 9000), {}}};
  for (int i = 0; i < 5; ++i) land.push_back({disc({12000.0 + 900.0 * i, 3000.0 * i}, 400), {}});
  const std::vector<Lobe> lobes = find_lobes(land);
  for (int i = 0; i < 5; ++i) {
    const Vec2 place{12000.0 + 900.0 * i, 3000.0 * i};
    EXPECT_TRUE(std::any_of(lobes.begin(), lobes.end(), [&](const Lobe& lobe) {
      return std::hypot(lobe.centre.x - place.x, lobe.centre.y - place.y) < 100;
    })) << i;
  }
}

TEST(NaturalHeight, IsATwentiethOfTheWidthOfAShieldAndMoreForSmallIslands) {
  EXPECT_NEAR(natural_height(30000), 1500, 150);
  EXPECT_GT(natural_height(8000), 8000 / 20.0);
  EXPECT_LT(natural_height(200000), 4201);
}

TEST(Build, ALobeRisesAsHighAsAnIslandOfItsWidth) {
  for (const uint64_t seed : {1U, 7U, 23U}) {
    const Plan plan = plan_of({two_lobes(15000, 6500, 22500)});
    const GridFrame frame{300, 240, 250.0, -27500, 30000, {}};
    const Island isle = build(plan, {.peak_m = 2241.0}, frame, Seed{seed}, {});
    EXPECT_NEAR(highest_near(isle.terrain, {0, 0}, 8000), 2241, 1) << seed;
    const double alone = 2241 * natural_height(13000) / natural_height(30000);  // 1166 m; Tahiti Iti: 1332
    EXPECT_NEAR(highest_near(isle.terrain, {22500, 0}, 5000), alone, 0.3 * alone) << seed;
    EXPECT_LT(highest_near(isle.terrain, {15500, 0}, 900), 0.5 * alone) << seed;  // the isthmus
  }
}

TEST(Build, TheHighestCellIsThePeakToTheMetreUnderAllDetail) {
  for (const uint64_t seed : {1U, 2U, 3U}) {
    for (const double relief : {0.0, 1.0, 2.0}) {
      for (const double massif : {0.0, 1.0}) {
        const GridFrame frame = GridFrame::centred(160, 150, 120);
        BuildParams params{.peak_m = 1234.0, .massif = massif, .relief = relief};
        params.detail.noise_m = 20;
        for (const Plan& plan : {random_plan(frame, {}, 0.5, Seed{seed}, {}), plan_of({two_lobes(4000, 1500, 6000)})}) {
          const Island isle = build(plan, params, frame, Seed{seed}, {});
          EXPECT_NEAR(*std::max_element(isle.terrain.cells().begin(), isle.terrain.cells().end()), 1234, 1)
              << seed << " " << relief << " " << massif;
        }
      }
    }
  }
}

TEST(Build, GivenSummitsStandWhereAndAsHighAsTheyWereAskedFor) {
  for (const uint64_t seed : {1U, 2U, 3U}) {
    const Plan plan = plan_of({{{{-9000, -5000}, {9000, -5000}, {9000, 5000}, {-9000, 5000}}, {}}});
    BuildParams params;
    params.summits = {{{-5000, 1000}, 900.0, {}}, {{4000, -500}, 1500.0, {}}};
    const Island isle = build(plan, params, GridFrame::centred(280, 200, 100), Seed{seed}, {});
    EXPECT_NEAR(highest_near(isle.terrain, {-5000, 1000}, 700), 900, 1) << seed;
    EXPECT_NEAR(highest_near(isle.terrain, {4000, -500}, 1500), 1500, 1) << seed;
    EXPECT_NEAR(*std::max_element(isle.terrain.cells().begin(), isle.terrain.cells().end()), 1500, 1);
  }
}

TEST(Build, ASummitHasItsOwnProfile) {
  const Plan plan = plan_of({{disc({0, 0}, 5000), {}}});
  BuildParams params{.massif = 0.0, .relief = 0.0};
  params.detail.noise_m = 0;
  params.summits = {{{0, 0}, 800.0, {{{0, 0.6}, {0.2, 1.0}, {0.5, 0.3}, {1, 0}}}}};  // a crater
  const Island isle = build(plan, params, GridFrame::centred(201, 201, 100), Seed{1}, {});
  double floor = 0, rim = 0;
  for (int i = 0; i < 64; ++i) {
    const double a = 2 * std::numbers::pi * i / 64;
    floor += isle.terrain(100 + static_cast<int>(std::lround(2 * std::cos(a))),
                          100 + static_cast<int>(std::lround(2 * std::sin(a)))) /
             64;
    rim += isle.terrain(100 + static_cast<int>(std::lround(9 * std::cos(a))),
                        100 + static_cast<int>(std::lround(9 * std::sin(a)))) /
           64;
  }
  EXPECT_GT(rim, floor + 80);
  EXPECT_NEAR(*std::max_element(isle.terrain.cells().begin(), isle.terrain.cells().end()), 800, 1);
}

TEST(Build, RefusesASummitInTheSea) {
  BuildParams params;
  params.summits = {{{0, 0}, 800.0, {}}, {{9000, 0}, 500.0, {}}};
  try {
    build(plan_of({{disc({0, 0}, 5000), {}}}), params, GridFrame::centred(201, 201, 100), Seed{1}, {});
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("summits[1].place: (9000, 0) does not lie on the land"));
  }
}

TEST(Build, PolarOutlinesTakeSummitsToo) {
  BuildParams params;
  params.summits = {{{-1500, 0}, 700.0, {}}};
  const Island isle = build(plan_from_polar({{{3000, 3600, 2800, 3300}}}, {}, {}), params,
                            GridFrame::centred(160, 160, 80), Seed{4}, {});
  EXPECT_NEAR(highest_near(isle.terrain, {-1500, 0}, 700), 700, 1);
}

}  // namespace
}  // namespace seamount::island
