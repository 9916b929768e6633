// Windows: finer frames within a scene, continued at their border, that change nothing outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/ops/ecosystem/environment.h"
#include "seamount/ops/ecosystem/grow.h"
#include "seamount/ops/ecosystem/test_scene.h"

namespace seamount::ecosystem {
namespace {

/// Corals on coarse cells; polyps, that live of the corals' lime, on fine ones; fleas on the finest.
Catalogue three_scales() {
  Catalogue catalogue = small_catalogue();
  catalogue.materials[0].flow_coupling = 0.2;
  catalogue.classes[0].placement.finest_cell_m = 5.0;
  catalogue.classes[1].placement.finest_cell_m = 5.0;
  catalogue.classes[0].height = {HeightShape::bump, HeightGroup::surface, 2.0, 40.0};
  ObjectClass polyp = point("polyp", "ramp(lime, 0.0, 0.02) * bell(depth, 6, 6)");
  polyp.birth = 0.05;
  polyp.placement = {.per_iteration = 40, .spacing_m = 0.5, .finest_cell_m = 0.1, .coarsest_cell_m = 1.0};
  polyp.deposits = {{"lime", 0.05, 0.6}};
  ObjectClass flea = point("flea", "1 - distance(polyp)");
  flea.birth = 0.1;
  flea.placement = {.per_iteration = 30, .spacing_m = 0.05, .coarsest_cell_m = 0.1};
  catalogue.classes.push_back(polyp);
  catalogue.classes.push_back(flea);
  return catalogue;
}

Scene coarse_scene(const HeightField& ground) { return grown(ground, three_scales(), some(4)).scene; }

Vec2 of_first(const Scene& scene, int of_class) {
  for (const SceneObject& object : scene.objects)
    if (object.of_class == of_class) return object.skeleton.points[0];
  return {};
}

Scene grown_in(const HeightField& ground, const Scene& scene, const WindowParams& window, int iterations) {
  GrowParams params = some(iterations);
  params.window = window;
  return grow({ground, nullptr, &scene}, params, Seed{1}, {}).scene;
}

/// What a scene is but for its windows and for numbers, which windows take their share of.
std::vector<SceneObject> coarse_objects(const Scene& scene) {
  std::vector<SceneObject> objects;
  for (SceneObject object : scene.objects) {
    if (object.window != 0) continue;
    object.id = 0;
    objects.push_back(object);
  }
  return objects;
}

TEST(SceneWindow, GrowsOtherClassesAndLeavesTheRestAlone) {
  const HeightField ground = shore();
  const Scene before = coarse_scene(ground);
  const Scene after = grown_in(ground, before, {0.25, of_first(before, 0), 24, 16}, 3);
  EXPECT_EQ(count(before, "polyp"), 0);
  EXPECT_GT(count(after, "polyp"), 20);
  EXPECT_EQ(coarse_objects(after), coarse_objects(before));
  EXPECT_EQ(after.iteration, before.iteration);
  ASSERT_EQ(after.windows.size(), 1U);
  EXPECT_EQ(after.windows[0].iteration, 3);
  for (const SceneObject& object : after.objects) {
    if (object.of_class != 2) continue;
    const Vec2 off = object.skeleton.points[0] - of_first(before, 0);
    EXPECT_TRUE(std::abs(off.x) <= 12 && std::abs(off.y) <= 8);
    EXPECT_EQ(object.window, 1);
  }
}

TEST(SceneWindow, TheSceneGrowsOnAsIfItHadNeverBeenOpened) {
  const HeightField ground = shore();
  const Scene before = coarse_scene(ground);
  const Scene opened = grown_in(ground, before, {0.25, of_first(before, 0), 24, 16}, 3);
  const Grown without = grow({ground, nullptr, &before}, some(4), Seed{1}, {});
  const Grown with = grow({ground, nullptr, &opened}, some(4), Seed{1}, {});
  EXPECT_EQ(coarse_objects(with.scene), coarse_objects(without.scene));
  EXPECT_EQ(with.terrain, without.terrain);
  EXPECT_EQ(with.current, without.current);
  EXPECT_EQ(count(with.scene, "polyp"), count(opened, "polyp"));
}

TEST(SceneWindow, GoesOnFromWhereItStood) {
  const HeightField ground = shore();
  const Scene before = coarse_scene(ground);
  const WindowParams window{0.25, of_first(before, 0), 24, 16};
  const Scene at_once = grown_in(ground, before, window, 5);
  EXPECT_EQ(grown_in(ground, grown_in(ground, before, window, 2), window, 3), at_once);
}

TEST(SceneWindow, ContinuesWhatSurroundsIt) {
  const HeightField ground = shore();
  Scene scene = coarse_scene(ground);
  scene.windows.push_back({GridFrame{80, 60, 0.5, -60.0, 30.0, {}}});
  const Rules rules = compile(scene.catalogue);
  const Site site{ground};
  const Environment coarse = make_environment(scene, rules, site, 0, scene.iteration, {});
  const Environment fine = make_environment(scene, rules, site, 1, scene.iteration, {});
  const auto at = [](const ScalarField& field, Vec2 p) {
    const double column = field.frame().column(p.x), row = field.frame().row(p.y);
    const int x = static_cast<int>(column), y = static_cast<int>(row);
    const double u = column - x, v = row - y;
    return (1 - v) * ((1 - u) * field(x, y) + u * field(x + 1, y)) +
           v * ((1 - u) * field(x, y + 1) + u * field(x + 1, y + 1));
  };
  float most = 0;
  for (const float v : coarse.materials[0].cells()) most = std::max(most, v);
  for (int y = 0; y < fine.frame.height; ++y) {
    for (int x = 0; x < fine.frame.width; ++x) {
      const Vec2 p{fine.frame.x(x), fine.frame.y(y)};
      ASSERT_NEAR(fine.current.x(x, y), at(coarse.current.x, p), 1e-5);
      ASSERT_NEAR(fine.current.y(x, y), at(coarse.current.y, p), 1e-5);
      ASSERT_NEAR(fine.height(x, y), at(coarse.height, p), 1.0) << "bumps, and bends of the ground between cells";
      const bool border = x == 0 || y == 0 || x == fine.frame.width - 1 || y == fine.frame.height - 1;
      if (border) {
        ASSERT_NEAR(fine.materials[0](x, y), at(coarse.materials[0], p), 0.05 * most);
      }
    }
  }
}

TEST(SceneWindow, HoldsAnother) {
  const HeightField ground = shore();
  const Scene island = coarse_scene(ground);
  const Vec2 coral = of_first(island, 0);
  const Scene metre = grown_in(ground, island, {1.0, coral, 60, 60}, 2);
  ASSERT_GT(count(metre, "polyp"), 10);
  const Scene colony = grown_in(ground, metre, {0.05, of_first(metre, 2), 3, 3}, 3);
  EXPECT_GT(count(colony, "flea"), 10);
  EXPECT_EQ(count(colony, "polyp"), count(metre, "polyp"));
  EXPECT_EQ(coarse_objects(colony), coarse_objects(island));
  for (const SceneObject& object : colony.objects) EXPECT_EQ(object.window == 2, object.of_class == 3);
  // The colony continues the metre around it, not the island: it knows the lime of polyps nearby.
  const Rules rules = compile(colony.catalogue);
  const Environment inner = make_environment(colony, rules, {ground}, 2, colony.iteration, {});
  const Environment middle = make_environment(colony, rules, {ground}, 1, colony.iteration, {});
  const int x = static_cast<int>(middle.frame.column(inner.frame.x(0))),
            y = static_cast<int>(middle.frame.row(inner.frame.y(0)));
  float low = 1e9F, high = 0;
  for (int k = 0; k < 4; ++k) {
    low = std::min(low, middle.materials[0](x + k % 2, y + k / 2));
    high = std::max(high, middle.materials[0](x + k % 2, y + k / 2));
  }
  EXPECT_GE(inner.materials[0](0, 0), 0.9F * low);
  EXPECT_LE(inner.materials[0](0, 0), 1.1F * high);
}

TEST(SceneWindow, RefusesFramesThatAreNone) {
  const HeightField ground = shore(16);
  const Scene scene = coarse_scene(ground);
  const auto refused = [&](const WindowParams& window, const char* message) {
    EXPECT_THAT([&] { grown_in(ground, scene, window, 1); },
                testing::ThrowsMessage<InvalidArgument>(testing::HasSubstr(message)));
  };
  refused({0.5, {200, 0}, 20, 20}, "leaves the scene");
  refused({10.0, {0, 0}, 50, 50}, "is not finer than the scene's cells");
  refused({1e-5, {0, 0}, 100, 100}, "the window would have 10000000 x 10000000 cells");
}

}  // namespace
}  // namespace seamount::ecosystem
