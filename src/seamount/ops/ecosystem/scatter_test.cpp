#include "seamount/ops/ecosystem/scatter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "seamount/base/error.h"

namespace seamount::ecosystem {
namespace {

HeightField ramp() {
  HeightField heights(GridFrame{80, 60, 10.0, 500.0, 4000.0, {}});
  for (int y = 0; y < heights.height(); ++y)
    for (int x = 0; x < heights.width(); ++x) heights(x, y) = static_cast<float>(x) - 40.0F;
  return heights;
}

TEST(Scatter, KeepsItsDistanceAndItsHeights) {
  const HeightField ground = ramp();
  ScatterParams params;
  params.spacing_m = 30.0;
  params.min_height_m = -10.0;
  params.max_height_m = 20.0;
  for (const uint64_t seed : {1U, 2U, 3U}) {
    const Things all = scatter({ground}, params, {seed}, {});
    EXPECT_GT(all.things.size(), 100U);
    for (size_t i = 0; i < all.things.size(); ++i) {
      const Vec2 p = all.things[i].place;
      const double z = ground.frame().column(p.x) - 40.0;
      EXPECT_GE(z, -10.01);
      EXPECT_LE(z, 20.01);
      for (size_t j = 0; j < i; ++j) {
        const Vec2 way = p - all.things[j].place;
        EXPECT_GE(dot(way, way), 29.9 * 29.9);
      }
    }
  }
}

TEST(Scatter, FollowsADensity) {
  const HeightField ground = ramp();
  ScalarField density(ground.frame(), 0.0F);
  for (int y = 0; y < density.height(); ++y)
    for (int x = 0; x < density.width(); ++x) density(x, y) = x < 40 ? 0.0F : 0.5F;
  ScatterParams params;
  params.spacing_m = 12.0;
  const size_t full = scatter({ground}, params, {1}, {}).things.size();
  const Things half = scatter({ground, &density}, params, {1}, {});
  EXPECT_NEAR(static_cast<double>(half.things.size()), 0.25 * static_cast<double>(full),
              0.04 * static_cast<double>(full));
  for (const Thing& thing : half.things) EXPECT_GE(thing.place.x, 500.0 + 395.0);
}

TEST(Scatter, StandsAtDrawnPlacesAndWithinAreas) {
  const HeightField ground = ramp();
  Drawing points;
  points.points = {{{600.0, 3800.0}}, {{620.0, 3800.0}}};
  const Things two = scatter({ground, nullptr, &points}, {}, {1}, {});
  ASSERT_EQ(two.things.size(), 2U);
  EXPECT_EQ(two.things[1].place, (Vec2{620.0, 3800.0}));
  Drawing area;
  area.areas = {{"", {{{{600, 3500}, {800, 3500}, {800, 3700}, {600, 3700}}, {}}}}};
  ScatterParams params;
  params.spacing_m = 15.0;
  const Things grove = scatter({ground, nullptr, &area}, params, {1}, {});
  EXPECT_GT(grove.things.size(), 50U);
  for (const Thing& thing : grove.things)
    EXPECT_TRUE(thing.place.x >= 600 && thing.place.x <= 800 && thing.place.y <= 3700);
  const Things both = scatter({ground, nullptr, &points, &grove}, params, {1}, {});
  EXPECT_EQ(both.things.size(), grove.things.size() + 2);
  EXPECT_EQ(both.shapes[both.things.back().shape], two.shapes[two.things.back().shape]);
}

TEST(Scatter, SaysWhatCannotBe) {
  const HeightField ground = ramp();
  ScatterParams params;
  params.spacing_m = 0.05;
  EXPECT_THROW(scatter({ground}, params, {1}, {}), InvalidArgument);
  params.spacing_m = 50.0;
  params.min_height_m = 5000.0;
  std::string said;
  RunContext run;
  run.note = [&](const std::string& line) { said += line; };
  EXPECT_TRUE(scatter({ground}, params, {1}, run).things.empty());
  EXPECT_THAT(said, ::testing::HasSubstr("nothing stands anywhere"));
  params.min_height_m = 3.0;
  params.max_height_m = 2.0;
  EXPECT_THROW(scatter({ground}, params, {1}, {}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::ecosystem
