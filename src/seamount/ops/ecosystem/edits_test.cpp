// Edits by hand: what they do, what they refuse, and that an edit undone leaves no trace.
#include "seamount/ops/ecosystem/edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/ops/ecosystem/grow.h"
#include "seamount/ops/ecosystem/test_scene.h"

namespace seamount::ecosystem {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

ObjectChoice number(int id) { return {id, "", {}}; }
ObjectChoice nearest(const char* of_class, Vec2 to) { return {0, of_class, to}; }

/// Two corals and a wall of five points, on 400 m of sea.
Scene reef() {
  Scene scene = still_scene(GridFrame::centred(40, 40, 10.0));
  scene.catalogue.classes = {point("coral", "1"), curve("wall", "1"), region("bank", "1")};
  add_object(scene, 0, {{-50, 0}});
  add_object(scene, 0, {{60, 10}});
  add_object(scene, 1, {{-100, 100}, {-50, 100}, {0, 100}, {50, 100}, {100, 100}});
  return scene;
}

bool apply(const std::vector<SceneEdit>& edits, Scene& scene) { return apply_edits(edits, scene, 0, {}); }

TEST(SceneEdits, AddWithTheNextNumber) {
  Scene scene = reef();
  EXPECT_TRUE(apply({AddEdit{0, "coral", {{1, 2}}}, AddEdit{0, "wall", {{1, 2}, {3, 4}}, false, false, 2.0}}, scene));
  ASSERT_EQ(scene.objects.size(), 5U);
  EXPECT_EQ(scene.objects[3].id, 4U);
  EXPECT_TRUE(scene.objects[3].keep);
  EXPECT_EQ(scene.objects[3].skeleton.hold, std::vector<float>{1.0F});
  EXPECT_EQ(scene.objects[4].id, 5U);
  EXPECT_EQ(scene.objects[4].size, 2.0);
  EXPECT_FALSE(scene.objects[4].keep);
  EXPECT_THAT(scene.objects[4].skeleton.hold, IsEmpty());
  EXPECT_EQ(scene.next_id, 6U);
}

TEST(SceneEdits, TurnOutlinesCounterClockwise) {
  Scene scene = reef();
  apply({AddEdit{0, "bank", {{0, 0}, {0, 50}, {50, 50}, {50, 0}}}}, scene);
  EXPECT_EQ(scene.objects[3].skeleton.points, (Polyline{{50, 0}, {50, 50}, {0, 50}, {0, 0}}));
}

TEST(SceneEdits, MoveByNumberAndByNearest) {
  Scene scene = reef();
  apply({MoveEdit{0, number(2), {5, -3}}, MoveEdit{0, nearest("coral", {-60, 5}), {1, 1}},
         MoveEdit{0, nearest("", {90, 98}), {0, -20}}},
        scene);
  EXPECT_EQ(scene.objects[1].skeleton.points[0], (Vec2{65, 7}));
  EXPECT_EQ(scene.objects[0].skeleton.points[0], (Vec2{-49, 1}));
  EXPECT_EQ(scene.objects[2].skeleton.points[0], (Vec2{-100, 80})) << "the wall lies nearest to that place";
}

TEST(SceneEdits, BendHoldAndDelete) {
  Scene scene = reef();
  apply({BendEdit{0, number(3), {0, 100}, {0, 40}, 60.0}}, scene);
  const Skeleton wall = scene.objects[2].skeleton;
  double top = 0;
  size_t locked = 0;
  for (size_t i = 0; i < wall.points.size(); ++i) {
    top = std::max(top, wall.points[i].y);
    const bool far = wall.points[i].y - 100 > 20;
    EXPECT_EQ(wall.hold[i] >= 1.0F, far) << "what moved by more than half of it stays there";
    locked += far ? 1 : 0;
  }
  EXPECT_NEAR(top, 140, 1e-9);
  EXPECT_GT(locked, 0U);
  apply({HoldEdit{0, number(3), {0, 0}, 1e6, 0.5}, HoldEdit{0, number(1), {-50, 0}, 1.0, 1.0}}, scene);
  for (const float h : scene.objects[2].skeleton.hold) EXPECT_EQ(h, 0.5F);
  EXPECT_EQ(scene.objects[0].skeleton.hold, std::vector<float>{1.0F});
  apply({DeleteEdit{0, nearest("coral", {0, 0})}}, scene);
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(scene.objects[0].id, 2U);
  EXPECT_EQ(scene.next_id, 4U) << "a number is never given twice";
}

TEST(SceneEdits, AreDoneOnlyWhenTheyAreDue) {
  Scene scene = reef();
  const Scene before = scene;
  EXPECT_FALSE(apply({DeleteEdit{1, number(1)}, AddEdit{7, "nothing", {}}}, scene));
  EXPECT_EQ(scene, before);
  scene.iteration = 1;
  EXPECT_TRUE(apply({DeleteEdit{1, number(1)}}, scene));
}

TEST(SceneEdits, RefuseWithTheirPlaceAndChangeNothing) {
  Scene scene = reef();
  const Scene before = scene;
  const auto refused = [&](const SceneEdit& bad, const char* message) {
    const std::vector<SceneEdit> edits = {MoveEdit{0, number(1), {1, 1}}, bad};
    EXPECT_THAT([&] { apply(edits, scene); }, testing::ThrowsMessage<InvalidArgument>(HasSubstr(message)));
    EXPECT_EQ(scene, before) << message;
  };
  refused(AddEdit{0, "corall", {{0, 0}}}, "edits[1].class: unknown class 'corall', did you mean 'coral'?");
  refused(AddEdit{0, "coral", {{0, 0}, {1, 1}}}, "edits[1].points: a point has one place, found 2");
  refused(AddEdit{0, "wall", {{0, 0}}}, "edits[1].points: a curve has two places or more, found 1");
  refused(AddEdit{0, "bank", {{0, 0}, {1, 1}}}, "edits[1].points: a region has three places or more, found 2");
  refused(AddEdit{0, "coral", {{0, 500}}}, "edits[1].points: the place");
  refused(AddEdit{0, "coral", {{0, std::nan("")}}}, "edits[1].points: the place");
  refused(AddEdit{0, "bank", {{0, 0}, {50, 50}, {50, 0}, {0, 50}}}, "edits[1].points: the outline");
  refused(MoveEdit{0, number(9), {1, 1}}, "edits[1].object.id: there is no object 9");
  refused(MoveEdit{0, number(2), {1000, 0}}, "edits[1].by: the place");
  refused(MoveEdit{0, nearest("bank", {0, 0}), {1, 0}}, "edits[1].object: there is no object of the class 'bank'");
  refused(MoveEdit{0, nearest("bnak", {0, 0}), {1, 0}}, "edits[1].object.class: unknown class 'bnak'");
  refused(BendEdit{0, number(1), {0, 0}, {1, 0}, 10.0}, "edits[1].object: a point does not bend");
  refused(DeleteEdit{0, number(4)}, "edits[1].object.id: there is no object 4");
}

TEST(SceneEdits, LeaveTheObjectsOfOtherFramesAlone) {
  Scene scene = reef();
  scene.windows = {{GridFrame::centred(20, 20, 1.0)}};
  scene.objects[0].window = 1;
  EXPECT_THAT(
      [&] {
        apply_edits({DeleteEdit{0, number(2)}}, scene, 1, {});
      },
      testing::ThrowsMessage<InvalidArgument>(
          HasSubstr("object 2 lives in another frame of the scene: edit it while the whole scene grows")));
  EXPECT_THAT(
      [&] {
        apply_edits({DeleteEdit{0, number(1)}}, scene, 0, {});
      },
      testing::ThrowsMessage<InvalidArgument>(HasSubstr("edit it while its window grows")));
}

TEST(SceneEdits, UndoneLeaveTheBytesFromBefore) {
  const HeightField ground = shore();
  GrowParams params = some(6);
  const Scene plain = grown(ground, small_catalogue(), params).scene;
  params.edits = {AddEdit{2, "coral", {{-100, 100}}}, MoveEdit{3, nearest("coral", {0, 0}), {40, 0}},
                  DeleteEdit{4, nearest("alga", {0, 0})}};
  const Scene edited = grown(ground, small_catalogue(), params).scene;
  EXPECT_NE(edited, plain);
  params.edits.pop_back();
  EXPECT_NE(grown(ground, small_catalogue(), params).scene, edited);
  params.edits.clear();
  EXPECT_EQ(grown(ground, small_catalogue(), params).scene, plain);
}

TEST(SceneEdits, InTheMiddleGoOnIdenticallyAfterSaving) {
  const HeightField ground = shore();
  GrowParams params = some(6);
  params.edits = {AddEdit{2, "coral", {{-100, 100}}}, MoveEdit{4, nearest("coral", {0, 0}), {40, 0}}};
  const Scene whole = grown(ground, small_catalogue(), params).scene;
  params.iterations = 3;
  const Scene half = grown(ground, small_catalogue(), params).scene;
  EXPECT_EQ(grow({ground, nullptr, &half}, params, Seed{1}, {}).scene, whole);
}

/// How many corals stand within `reach` of a place.
int corals_at(const Scene& scene, Vec2 at, double reach) {
  int n = 0;
  for (const SceneObject& object : scene.objects) {
    const Vec2 off = object.skeleton.points[0] - at;
    n += object.of_class == 0 && std::hypot(off.x, off.y) < reach ? 1 : 0;
  }
  return n;
}

TEST(SceneEdits, ABentCanyonKillsCoralsThatEndUpTooDeepAndGrowsNewOnes) {  // fig. 1.36
  const HeightField ground(GridFrame::centred(64, 64, 10.0), -6.0F);
  Catalogue catalogue;
  catalogue.classes = {point("coral", "bell(depth, 6, 3)"), curve("canyon", "1")};
  ObjectClass& coral = catalogue.classes[0];
  coral.birth = 0.5;
  coral.death = 0.4;
  coral.shape.steps = 0;
  coral.placement.per_iteration = 400;
  coral.placement.spacing_m = 12.0;
  catalogue.classes[1].placement.per_iteration = 0;
  catalogue.classes[1].height = {HeightShape::carve, HeightGroup::surface, 20.0, 80.0, 1.0};
  GrowParams params = some(6);
  params.edits = {AddEdit{0, "canyon", {{-300, 0}, {-150, 0}, {0, 0}, {150, 0}, {300, 0}}}};
  const Scene before = grow({ground, &catalogue}, params, Seed{3}, {}).scene;
  const Vec2 bed{0, 0}, beside{0, 150};
  EXPECT_EQ(corals_at(before, bed, 20), 0);
  const int lived = corals_at(before, beside, 20);
  EXPECT_GT(lived, 0);
  GrowParams bend = some(1);
  bend.edits = {BendEdit{6, nearest("canyon", {0, 0}), {0, 0}, {0, 150}, 90.0}};
  const Scene bent = grow({ground, nullptr, &before}, bend, Seed{3}, {}).scene;
  EXPECT_EQ(corals_at(bent, beside, 20), 0) << "too deep at once";
  bend.iterations = 8;
  const Scene after = grow({ground, nullptr, &before}, bend, Seed{3}, {}).scene;
  EXPECT_GT(corals_at(after, bed, 40), 0) << "new ones where the canyon was";
  EXPECT_EQ(corals_at(after, beside, 20), 0);
  EXPECT_EQ(corals_at(after, {-250, -200}, 60), corals_at(before, {-250, -200}, 60)) << "far away nothing";
}

}  // namespace
}  // namespace seamount::ecosystem
