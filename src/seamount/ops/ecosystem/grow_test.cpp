// Laws of life.
#include "seamount/ops/ecosystem/grow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/ecosystem/fitness.h"
#include "seamount/ops/ecosystem/test_scene.h"

namespace seamount::ecosystem {
namespace {

using testing::AnyOf;
using testing::Contains;
using testing::HasSubstr;

TEST(GrowScene, NoObjectBelowItsThresholdSurvives) {
  const HeightField ground = shore();
  for (const uint64_t seed : {1, 2, 3}) {
    const Scene scene = grown(ground, small_catalogue(), some(6), seed).scene;
    EXPECT_GT(count(scene, "coral"), 50);
    EXPECT_GT(count(scene, "alga"), 10);
    const Rules rules = compile(scene.catalogue);
    const Environment environment = make_environment(scene, rules, {ground}, 0, scene.iteration, {});
    std::vector<size_t> all(scene.objects.size());
    for (size_t i = 0; i < all.size(); ++i) all[i] = i;
    const std::vector<double> fitness = fitness_of(scene, rules, environment, all, {});
    for (size_t i = 0; i < all.size(); ++i) {
      EXPECT_GE(fitness[i], scene.catalogue.classes[static_cast<size_t>(scene.objects[i].of_class)].death);
      EXPECT_EQ(fitness[i], scene.objects[i].fitness) << "as it was last asked";
    }
  }
}

TEST(GrowScene, ObjectsOfAClassKeepTheirDistanceAtBirth) {
  Catalogue catalogue = small_catalogue();
  catalogue.classes[0].shape.steps = 0;
  const Scene scene = grown(shore(), catalogue, some(5)).scene;
  std::vector<Vec2> corals;
  for (const SceneObject& object : scene.objects)
    if (object.of_class == 0) corals.push_back(object.skeleton.points[0]);
  for (size_t i = 0; i < corals.size(); ++i)
    for (size_t k = 0; k < i; ++k) EXPECT_GE(std::hypot(corals[i].x - corals[k].x, corals[i].y - corals[k].y), 15.0);
}

TEST(GrowScene, SameSeedSameSceneOnAnyNumberOfThreads) {
  const HeightField ground = shore();
  const Scene one = grown(ground, small_catalogue(), some(4), 7, {.threads = 1}).scene;
  EXPECT_EQ(grown(ground, small_catalogue(), some(4), 7, {.threads = 3}).scene, one);
  EXPECT_NE(grown(ground, small_catalogue(), some(4), 8).scene.objects, one.objects);
}

TEST(GrowScene, GoesOnFromWhereItStoodAsIfItHadNotStopped) {
  const HeightField ground = shore();
  GrowParams params = some(7);
  params.timeline = {WaterLevelEvent{2, 6, -3.0}, StormEvent{3, 5, {-100, 0}, 2.0, 90.0, 80.0}};
  const Scene whole = grown(ground, small_catalogue(), params).scene;
  params.iterations = 3;
  const Scene half = grown(ground, small_catalogue(), params).scene;
  const Scene rest = grow({ground, nullptr, &half}, some(4), Seed{99}, {}).scene;
  EXPECT_EQ(rest, whole);
}

TEST(GrowScene, ReachesTargetsAndStops) {
  GrowParams params = some(50);
  params.targets = {{"coral", 33}, {"alga", 5}};
  const Scene scene = grown(shore(), small_catalogue(), params).scene;
  EXPECT_EQ(count(scene, "coral"), 33);
  EXPECT_EQ(count(scene, "alga"), 5);
  EXPECT_LT(scene.iteration, 50);
}

TEST(GrowScene, SaysWhyATargetIsMissedAndWhatNeverGrew) {
  Catalogue catalogue = small_catalogue();
  catalogue.classes[0].placement.spacing_m = 400.0;
  catalogue.classes.push_back(point("palm", "ramp(height, 100, 200)"));
  catalogue.classes.push_back(point("odd", "log(x)"));
  GrowParams params = some(3);
  params.targets = {{"coral", 100}};
  std::vector<std::string> notes;
  RunContext run;
  run.note = [&](const std::string& line) { notes.push_back(line); };
  grown(shore(), catalogue, params, 7, run);
  EXPECT_THAT(notes, Contains(AllOf(HasSubstr("coral: "), HasSubstr(" of 100 wanted: "))));
  EXPECT_THAT(notes, Contains(HasSubstr("palm: none was born: the largest fitness found was 0 at")));
  EXPECT_THAT(notes, Contains(HasSubstr("odd: its fitness has no value at")));
}

TEST(GrowScene, FallingWaterKillsWhatIsLeftDryAndDeeperPlacesAreSettled) {
  const HeightField ground = shore();
  Catalogue catalogue = small_catalogue();
  GrowParams params = some(5);
  const Grown before = grown(ground, catalogue, params);
  GrowParams falling = some(12);
  falling.timeline = {WaterLevelEvent{5, 12, -8.0}};
  const Scene after = grow({ground, nullptr, &before.scene}, falling, Seed{7}, {}).scene;
  double shallow = 0, deep = 0;
  for (const SceneObject& object : before.scene.objects)
    if (object.of_class == 0) shallow += object.skeleton.points[0].x;
  for (const SceneObject& object : after.objects)
    if (object.of_class == 0) deep += object.skeleton.points[0].x;
  EXPECT_LT(deep / count(after, "coral"), shallow / count(before.scene, "coral") - 40.0) << "down the slope";
  EXPECT_GT(count(after, "coral"), 30);
}

TEST(GrowScene, AStormKillsOnlyWhatIsSensitive) {
  Catalogue catalogue = small_catalogue();
  catalogue.classes = {point("tough", "bell(depth, 6, 3)"),
                       point("frail", "bell(depth, 6, 3) - max(0, current - 0.5)")};
  for (ObjectClass& of : catalogue.classes) {
    of.birth = 0.5;
    of.death = 0.3;
    of.placement.per_iteration = 60;
    of.placement.spacing_m = 8.0;
    of.placement.reinsert = false;
  }
  const HeightField ground = shore();
  const Scene before = grown(ground, catalogue, some(3)).scene;
  GrowParams storm = some(1);
  storm.timeline = {StormEvent{4, 5, {-100, 100}, 3.0, 0.0, 60.0}};
  Catalogue no_more = catalogue;
  for (ObjectClass& of : no_more.classes) of.placement.per_iteration = 0;
  const Scene after = grow({ground, &no_more, &before}, storm, Seed{7}, {}).scene;
  EXPECT_EQ(count(after, "tough"), count(before, "tough"));
  EXPECT_LT(count(after, "frail"), count(before, "frail"));
  EXPECT_GT(count(after, "frail"), 0) << "far away";
}

TEST(GrowScene, IsLockedIntoTheFocus) {
  const HeightField ground = shore();
  Mask focus(ground.frame(), 0.0F);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < focus.width(); ++x) focus(x, y) = 1.0F;
  const Catalogue catalogue = small_catalogue();
  const Scene scene = grow({ground, &catalogue, nullptr, &focus}, some(3), Seed{1}, {}).scene;
  EXPECT_GT(count(scene, "coral"), 5);
  for (const SceneObject& object : scene.objects)
    EXPECT_TRUE(object.of_class != 0 || object.skeleton.points[0].y > ground.frame().y(21));
}

TEST(GrowScene, OwesNothingForWhatDiesAsItIsBorn) {
  Catalogue catalogue = small_catalogue();
  catalogue.classes = {point("mayfly", "1 - 100 * lime")};
  catalogue.classes[0].birth = 0.5;
  catalogue.classes[0].placement.per_iteration = 5;
  catalogue.classes[0].deposits = {{"lime", 1.0, 20.0}};
  const Scene scene = grown(shore(), catalogue, some(6)).scene;
  EXPECT_EQ(count(scene, "mayfly"), 0);
  for (const Owed& owed : scene.owed) EXPECT_EQ(owed.count, 0);
}

TEST(GrowScene, SaysThatNoSkeletonCouldGrow) {
  Catalogue catalogue;
  catalogue.classes = {curve("endless", "1")};
  catalogue.classes[0].shape.length_m = 1e6;
  std::vector<std::string> notes;
  RunContext run;
  run.note = [&](const std::string& line) { notes.push_back(line); };
  const Scene scene = grown(shore(), catalogue, some(2), 7, run).scene;
  EXPECT_TRUE(scene.objects.empty());
  EXPECT_THAT(notes, Contains(HasSubstr("endless: none was born: no skeleton could grow where it is fit")));
}

TEST(GrowScene, RefusesACurrentThatLiesElsewhere) {
  const HeightField ground = shore(8);
  const Catalogue catalogue = small_catalogue();
  const GridFrame other = GridFrame::centred(4, 4, 10.0);
  const VectorField current{ScalarField(other, 0.1F), ScalarField(other, 0.0F)};
  EXPECT_THROW(grow({ground, &catalogue, nullptr, nullptr, &current}, some(1), Seed{1}, {}), IncompatibleInputs);
}

TEST(GrowScene, RefusesWhatItCannotDo) {
  const HeightField ground = shore(8);
  EXPECT_THROW(grow({ground}, some(1), Seed{1}, {}), InvalidArgument);
  const Catalogue empty;
  EXPECT_THROW(grow({ground, &empty}, some(1), Seed{1}, {}), InvalidArgument);
  const Catalogue catalogue = small_catalogue();
  GrowParams params = some(1);
  params.targets = {{"corall", 3}};
  EXPECT_THAT([&] { grown(ground, catalogue, params); },
              testing::ThrowsMessage<InvalidArgument>(
                  HasSubstr("targets[0].class: unknown class 'corall', did you mean 'coral'?")));
  params = some(1);
  params.window = {0.5, {500, 0}, 10, 10};
  EXPECT_THAT([&] { grown(ground, catalogue, params); },
              testing::ThrowsMessage<InvalidArgument>(HasSubstr("leaves the scene")));
  const Scene scene = grown(ground, catalogue, some(0)).scene;
  const HeightField other = shore(9);
  EXPECT_THROW(grow({other, nullptr, &scene}, some(1), Seed{1}, {}), IncompatibleInputs);
}

}  // namespace
}  // namespace seamount::ecosystem
