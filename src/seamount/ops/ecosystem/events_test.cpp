// Events against their formulas, on the environment that objects see.
#include "seamount/ops/ecosystem/events.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/ops/ecosystem/environment.h"
#include "seamount/ops/ecosystem/test_scene.h"

namespace seamount::ecosystem {
namespace {

/// Deep sea without a current of its own.
struct Sea {
  explicit Sea(Timeline timeline) : ground(GridFrame::centred(60, 40, 20.0), -50.0F) {
    scene = still_scene(ground.frame());
    scene.catalogue.classes = {point("coral", "1")};
    scene.timeline = std::move(timeline);
    rules = compile(scene.catalogue);
  }
  Environment at(double time) const { return make_environment(scene, rules, {ground}, 0, time, {}); }

  HeightField ground;
  Scene scene;
  Rules rules;
};

double gauss(Vec2 from, Vec2 to, double radius) {
  return std::exp(-((from.x - to.x) * (from.x - to.x) + (from.y - to.y) * (from.y - to.y)) / (2 * radius * radius));
}

TEST(SceneEvents, WaterRisesLinearlyAndStays) {  // eq. 1.56
  const Sea sea({WaterLevelEvent{2, 6, 8.0}, WaterLevelEvent{4, 4, -1.0}});
  for (const auto& [time, level] :
       {std::pair(0.0, 0.0), {2.0, 0.0}, {3.0, 2.0}, {4.0, 4.0}, {5.0, 5.0}, {6.0, 7.0}, {60.0, 7.0}}) {
    const Environment made = sea.at(time);
    EXPECT_DOUBLE_EQ(made.water_level_m, level) << time;
    EXPECT_FLOAT_EQ(made.height(30, 20), -50.0F - static_cast<float>(level));
  }
}

TEST(SceneEvents, GroundSinksAroundAPlace) {  // eq. 1.57, fig. 1.40
  const Vec2 place{100, -60};
  const Sea sea({GroundEvent{0, 10, place, -12.0, 90.0}, GroundEvent{5, 6, {-300, 100}, 4.0, 50.0}});
  for (const double time : {0.0, 2.5, 7.0, 30.0}) {
    const Environment made = sea.at(time);
    for (int y = 0; y < made.frame.height; ++y) {
      for (int x = 0; x < made.frame.width; ++x) {
        const Vec2 at{made.frame.x(x), made.frame.y(y)};
        const double expected = -12.0 * std::min(1.0, time / 10) * gauss(at, place, 90) +
                                4.0 * event_progress(5, 6, time) * gauss(at, {-300, 100}, 50);
        ASSERT_NEAR(made.height(x, y) + 50.0, expected, 0.006) << time;  // cut at four deviations
      }
    }
  }
}

TEST(SceneEvents, AStormBlowsFromItsStartUntilBeforeItsEnd) {
  const Vec2 place{0, 40};
  const Sea sea({StormEvent{3, 5, place, 2.0, 90.0, 100.0}});
  for (const auto& [time, blows] : {std::pair(2.9, false), {3.0, true}, {4.9, true}, {5.0, false}}) {
    const Environment made = sea.at(time);
    for (int y = 0; y < made.frame.height; y += 3) {
      for (int x = 0; x < made.frame.width; x += 3) {
        const double expected = blows ? 2.0 * gauss({made.frame.x(x), made.frame.y(y)}, place, 100) : 0.0;
        ASSERT_NEAR(made.current.y(x, y), expected, 0.001) << time;
        ASSERT_NEAR(made.current.x(x, y), 0.0, 1e-6);
      }
    }
  }
}

TEST(SceneEvents, ADrawnCurrentFollowsItsStroke) {  // fig. 1.38
  const Sea sea({CurrentEvent{0, 4, {{-400, 0}, {0, 0}, {400, 0}}, 1.5, 40.0}});
  const Environment made = sea.at(1);
  const auto column = [&](double x) { return static_cast<int>(std::lround(made.frame.column(x))); };
  const auto row = [&](double y) { return static_cast<int>(std::lround(made.frame.row(y))); };
  for (const double x : {-200.0, 0.0, 250.0}) {
    const int y = row(0);
    const double off = made.frame.y(y);
    EXPECT_NEAR(made.current.x(column(x), y), 1.5 * std::exp(-off * off / (2 * 40.0 * 40.0)), 0.03);
    EXPECT_NEAR(made.current.y(column(x), y), 0.0, 0.03);
    EXPECT_NEAR(made.current.x(column(x), row(300)), 0.0, 1e-3);
  }
  EXPECT_EQ(sea.at(4).current.x(column(0), row(0)), 0.0F);
}

TEST(SceneEvents, KnowWhenTheyChangeSomething) {
  const Timeline timeline = {WaterLevelEvent{2, 4, 1.0}, StormEvent{6, 8, {}, 1.0, 0.0, 10.0}};
  for (const auto& [from, changes] : {std::pair(0, false),
                                      {1, false},
                                      {2, true},
                                      {3, true},
                                      {4, false},
                                      {5, true},
                                      {6, false},
                                      {7, true},
                                      {8, false}})
    EXPECT_EQ(changes_between(timeline, from, from + 1), changes) << from;
}

}  // namespace
}  // namespace seamount::ecosystem
