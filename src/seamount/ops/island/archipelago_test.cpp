// Reefs of an archipelago: depths that do not scale, and one lagoon where two overlap.
#include "seamount/ops/island/archipelago.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/ops/island/build.h"
#include "seamount/ops/island/coral.h"

namespace seamount::island {
namespace {

Reefed barrier(uint64_t seed) {
  const Plan plan = plan_from_polar({{{1500}}}, {}, {.lagoon_m = 1500, .reef_m = 600, .slope_m = 1500});
  const Island isle =
      build(plan, {.peak_m = 400.0, .floor_m = -400.0}, GridFrame::centred(240, 240, 60), Seed{seed}, {});
  return coral(isle.terrain, isle.labels, &isle.coordinate,
               {.subsidence = 0.2,
                .exposure = 0,
                .passes = 0,
                .lagoon_relief_m = 0,
                .islets = 0,
                .section = {.back_end = 0.2, .crest_start = 0.4, .crest_end = 0.9}},
               Seed{seed}, {});
}

float highest_along(const Grid<float>& terrain, Vec2 from, Vec2 to) {
  float highest = -1e9F;
  for (int i = 0; i <= 400; ++i) {
    const Vec2 p = from + (i / 400.0) * (to - from);
    highest = std::max(highest, terrain.clamped(static_cast<int>(std::lround(terrain.frame().column(p.x))),
                                                static_cast<int>(std::lround(terrain.frame().row(p.y)))));
  }
  return highest;
}

TEST(Archipelago, TheCrestOfASmallIslandIsAsNearTheSurfaceAsThatOfALargeOne) {
  const Reefed one = barrier(1);
  const GridFrame frame = GridFrame::centred(800, 480, 30);
  for (const double scale : {0.4, 0.7, 1.0, 1.6}) {
    const Archipelago sea =
        archipelago({{&one.terrain, &one.labels}}, {.places = {{0, 0}}, .scales = {scale}}, frame, {});
    // East of the coast the crest is the highest place before the sea floor.
    const float crest = highest_along(sea.terrain, {2400 * scale, 0}, {6000 * scale, 0});
    EXPECT_NEAR(crest, -2.0F, 0.7F) << scale;
    const float lagoon = highest_along(sea.terrain, {2300 * scale, 0}, {2500 * scale, 0});
    EXPECT_NEAR(lagoon, -20.0F, 3.0F) << scale;
  }
}

TEST(Archipelago, WhereBarriersOverlapThereIsOneLagoon) {
  const Reefed one = barrier(1), other = barrier(2);
  const GridFrame frame = GridFrame::centred(400, 240, 60);
  const std::vector<Member> members = {{&one.terrain, &one.labels}, {&other.terrain, &other.labels}};
  for (const double apart : {3800.0, 4400.0, 5000.0}) {
    const Archipelago sea = archipelago(members, {.places = {{-apart / 2, 0}, {apart / 2, 0}}}, frame, {});
    // From shore to shore no wall stands; around both the reef is whole.
    EXPECT_LT(highest_along(sea.terrain, {-apart / 2 + 1700, 0}, {apart / 2 - 1700, 0}), -10.0F) << apart;
    EXPECT_GT(highest_along(sea.terrain, {0, 1000}, {0, 6000}), -3.0F) << apart;
    EXPECT_GT(highest_along(sea.terrain, {0, -1000}, {0, -6000}), -3.0F) << apart;
    const int y = static_cast<int>(std::lround(frame.row(0)));
    for (double x = -apart / 2 + 1700; x < apart / 2 - 1700; x += 60)
      EXPECT_EQ(sea.labels(static_cast<int>(std::lround(frame.column(x))), y), Region::lagoon) << apart << " at " << x;
  }
}

}  // namespace
}  // namespace seamount::island
