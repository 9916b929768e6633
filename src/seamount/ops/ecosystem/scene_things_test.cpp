#include "seamount/ops/ecosystem/scene_things.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/ops/ecosystem/test_scene.h"

namespace seamount::ecosystem {
namespace {

Scene grove() {
  Scene scene = still_scene(GridFrame::centred(50, 50, 10.0));
  auto& classes = scene.catalogue.classes;
  classes = {point("palm", "1"), curve("hedge", "1"), region("wood", "1"), point("bare", "1")};
  for (size_t c = 0; c < 3; ++c) classes[c].things = {{}};
  classes[0].birth = 0.8;
  classes[0].death = 0.4;
  classes[1].things_spacing_m = 10.0;
  classes[2].things_spacing_m = 20.0;
  add_object(scene, 0, {{-100, 0}});
  add_object(scene, 0, {{0, 0}});
  add_object(scene, 0, {{100, 0}});
  add_object(scene, 3, {{50, 50}});
  scene.objects[0].fitness = 0.4;
  scene.objects[1].fitness = 0.6;
  scene.objects[2].fitness = 2.0;
  return scene;
}

Things things_of(const Scene& scene) { return things(scene, HeightField(scene.frame, 3.0F), {}, {}, {}); }

TEST(SceneThings, AreOneForEachPoint) {
  const Things made = things_of(grove());
  ASSERT_EQ(made.things.size(), 3U) << "and none of a class without any";
  EXPECT_EQ(made.things[2].place, (Vec2{100, 0}));
  EXPECT_LT(made.things[0].health, 0.1F) << "at the threshold of death";
  EXPECT_NEAR(made.things[1].health, 0.5F, 0.1F) << "half way to that of birth";
  EXPECT_EQ(made.things[2].health, 1.0F);
}

TEST(SceneThings, StandAlongCurvesAndWithinRegions) {
  Scene scene = grove();
  scene.objects.clear();
  add_object(scene, 1, {{-200, 0}, {0, 0}, {0, 200}});
  EXPECT_NEAR(static_cast<double>(things_of(scene).things.size()), 40, 6);
  scene.objects.clear();
  add_object(scene, 2, {{-100, -100}, {100, -100}, {100, 100}, {-100, 100}});
  EXPECT_NEAR(static_cast<double>(things_of(scene).things.size()), 100, 12);
  scene.catalogue.classes[2].things_spacing_m = 0.0;
  EXPECT_EQ(things_of(scene).things.size(), 0U);
}

TEST(SceneThings, AreTheSameForTheSameObjects) {
  Scene scene = grove();
  const Things before = things_of(scene);
  EXPECT_EQ(things_of(scene), before);
  add_object(scene, 0, {{0, 100}});
  const Things after = things_of(scene);
  ASSERT_EQ(after.things.size(), 4U);
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(after.things[i].place, before.things[i].place);
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(after.things[i].rotation, before.things[i].rotation);
}

}  // namespace
}  // namespace seamount::ecosystem
