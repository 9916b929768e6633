// How objects live with and of one another: places they may be, chains of deaths, competition, materials.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/solve/transport.h"
#include "seamount/ops/ecosystem/environment.h"
#include "seamount/ops/ecosystem/grow.h"
#include "seamount/ops/ecosystem/materials.h"
#include "seamount/ops/ecosystem/test_scene.h"

namespace seamount::ecosystem {
namespace {

Polyline circle(Vec2 centre, double radius) {
  Polyline points;
  for (int i = 0; i < 48; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 48.0;
    points.push_back(centre + radius * Vec2{std::cos(a), std::sin(a)});
  }
  return points;
}

double mean_around(const ScalarField& field, Vec2 at, double radius) {
  double sum = 0.0;
  int n = 0;
  for (int y = 0; y < field.height(); ++y)
    for (int x = 0; x < field.width(); ++x)
      if (std::hypot(field.frame().x(x) - at.x, field.frame().y(y) - at.y) < radius)
        sum += static_cast<double>(field(x, y)), ++n;
  return sum / n;
}

TEST(LifeOfObjects, KeepsWithinAndOutsideOfRegions) {
  const HeightField ground(GridFrame::centred(60, 60, 10.0), 5.0F);
  Catalogue catalogue;
  catalogue.classes = {region("meadow", "1"), region("pond", "1"), point("flower", "1")};
  catalogue.classes[0].placement.per_iteration = catalogue.classes[1].placement.per_iteration = 0;
  catalogue.classes[2].placement = {.per_iteration = 200, .spacing_m = 8.0, .within = {"meadow"}, .outside = {"pond"}};
  const Polyline meadow = circle({-40, 20}, 150), other = circle({200, -200}, 60), pond = circle({0, 0}, 60);
  GrowParams params = some(3);
  params.edits = {AddEdit{0, "meadow", meadow}, AddEdit{0, "meadow", other}, AddEdit{0, "pond", pond}};
  const Scene scene = grow({ground, &catalogue}, params, Seed{4}, {}).scene;
  int in_other = 0;
  for (const SceneObject& object : scene.objects) {
    if (object.of_class != 2) continue;
    const Vec2 p = object.skeleton.points[0];
    EXPECT_TRUE(geom::contains(meadow, p) || geom::contains(other, p));
    EXPECT_FALSE(geom::contains(pond, p));
    in_other += geom::contains(other, p) ? 1 : 0;
  }
  EXPECT_GT(count(scene, "flower"), 200);
  EXPECT_GT(in_other, 15);
  // With its meadow a flower goes, and in a new pond.
  GrowParams next = some(1);
  next.edits = {DeleteEdit{3, {0, "meadow", {200, -200}}}, AddEdit{3, "pond", circle({-120, 60}, 40)}};
  for (ObjectClass& of : catalogue.classes) of.placement.per_iteration = 0, of.placement.reinsert = false;
  const Scene after = grow({ground, &catalogue, &scene}, next, Seed{4}, {}).scene;
  int gone = 0;
  for (const SceneObject& object : scene.objects) {
    if (object.of_class != 2) continue;
    const Vec2 p = object.skeleton.points[0];
    gone += geom::contains(other, p) || geom::contains(circle({-120, 60}, 40), p) ? 1 : 0;
  }
  EXPECT_EQ(count(after, "flower"), count(scene, "flower") - gone);
}

TEST(LifeOfObjects, EndsInChainsWithinOneIteration) {
  const HeightField ground(GridFrame::centred(60, 60, 10.0), -5.0F);
  Catalogue catalogue;
  catalogue.materials = {material("lime"), material("sugar")};
  catalogue.classes = {point("rock", "1"), point("coral", "lime"), point("alga", "sugar"),
                       point("snail", "1 - distance(alga) / 20")};
  for (ObjectClass& of : catalogue.classes) of.placement.per_iteration = 0;
  catalogue.classes[0].deposits = {{"lime", 0.2, 15.0}};
  catalogue.classes[1].deposits = {{"sugar", 0.2, 15.0}};
  catalogue.classes[1].death = catalogue.classes[1].birth = 0.05;
  catalogue.classes[2].death = catalogue.classes[2].birth = 0.05;
  for (ObjectClass& of : catalogue.classes) of.shape.steps = 0;
  GrowParams params = some(1);
  for (const Vec2 at : {Vec2{-150, 0}, Vec2{150, 0}}) {
    params.edits.push_back(AddEdit{0, "rock", {at}});
    params.edits.push_back(AddEdit{0, "coral", {at + Vec2{5, 5}}, true, false});
    params.edits.push_back(AddEdit{0, "alga", {at + Vec2{10, 0}}, true, false});
    params.edits.push_back(AddEdit{0, "snail", {at + Vec2{15, 0}}, true, false});
  }
  const Scene whole = grow({ground, &catalogue}, params, Seed{4}, {}).scene;
  ASSERT_EQ(whole.objects.size(), 8U);
  GrowParams next = some(1);
  next.edits = {DeleteEdit{1, {0, "rock", {-150, 0}}}};
  const Scene half = grow({ground, nullptr, &whole}, next, Seed{4}, {}).scene;
  ASSERT_EQ(half.objects.size(), 4U) << "the coral without lime, the alga without sugar, the snail without the alga";
  for (const SceneObject& object : half.objects) EXPECT_GT(object.skeleton.points[0].x, 0);
}

/// Three corals that differ in nothing but their own kind: data/catalogues/competition.json.
Catalogue three_colonies() {
  Catalogue catalogue;
  for (const char* name : {"polyp", "polyp_a", "polyp_b", "polyp_c"}) {
    catalogue.materials.push_back(material(name));
    catalogue.materials.back().diffusivity_m2_s = 1.5;
    catalogue.materials.back().decay_1_s = 0.05;
  }
  for (const std::string kind : {"a", "b", "c"}) {
    ObjectClass coral = point(
        "coral_" + kind, "(polyp_" + kind + " + 0.002) / (polyp + 0.006) * ramp(distance(coral_" + kind + "), 14, 9)");
    coral.birth = 0.5;
    coral.death = 0.32;
    coral.shape.steps = 0;
    coral.placement = {.per_iteration = 60,
                       .most = 4000,
                       .spacing_m = 4.0,
                       .samples = 20000,
                       .pick = Pick::weighted,
                       .reinsert = false};
    coral.deposits = {{"polyp", 0.02, 4.0}, {"polyp_" + kind, 0.02, 4.0}};
    catalogue.classes.push_back(coral);
  }
  return catalogue;
}

TEST(LifeOfObjects, CompetitionComesToAFrontThatStands) {  // fig. 1.47
  const HeightField ground(GridFrame::centred(90, 90, 2.0), -8.0F);
  Mask ring(ground.frame(), 0.0F);
  for (int y = 0; y < ring.height(); ++y)
    for (int x = 0; x < ring.width(); ++x) {
      const double r = std::hypot(ring.frame().x(x), ring.frame().y(y));
      ring(x, y) = r > 35 && r < 75 ? 1.0F : 0.0F;
    }
  const Catalogue catalogue = three_colonies();
  GrowParams params = some(50);
  params.edits = {AddEdit{0, "coral_a", {{0, 55}}}, AddEdit{0, "coral_b", {{-47, -27}}},
                  AddEdit{0, "coral_c", {{47, -27}}}};
  const Scene before = grow({ground, &catalogue, nullptr, &ring}, params, Seed{3}, {}).scene;
  const Scene after = grow({ground, nullptr, &before, &ring}, some(10), Seed{3}, {}).scene;
  std::set<uint64_t> lived, live;
  for (const SceneObject& object : before.objects) lived.insert(object.id);
  for (const SceneObject& object : after.objects) live.insert(object.id);
  std::vector<uint64_t> changed;
  std::set_symmetric_difference(lived.begin(), lived.end(), live.begin(), live.end(), std::back_inserter(changed));
  EXPECT_LT(changed.size(), 0.02 * static_cast<double>(live.size()));
  for (const char* kind : {"coral_a", "coral_b", "coral_c"}) EXPECT_GT(count(after, kind), 80) << kind;
  // Each keeps to its own third: hardly any stand deep in another's.
  int strangers = 0;
  for (const SceneObject& object : after.objects) {
    const Vec2 p = object.skeleton.points[0];
    const double to_front = std::abs(
        std::remainder(std::atan2(p.y, p.x) - std::numbers::pi / 2 - object.of_class * 2 * std::numbers::pi / 3,
                       2 * std::numbers::pi));
    strangers += to_front > 0.45 * std::numbers::pi ? 1 : 0;
  }
  EXPECT_LT(strangers, 0.1 * static_cast<double>(live.size()));
}

TEST(LifeOfObjects, WhatIsDepositedDecaysOrFlowsOut) {
  const HeightField ground = shore();
  Catalogue catalogue = small_catalogue();
  catalogue.materials.push_back(material("rubble"));
  catalogue.materials[0].flow_coupling = 0.5;
  catalogue.materials[0].density = 0.1;
  catalogue.classes[0].deposits.push_back({"rubble", 0.03, 10.0});
  catalogue.classes[1].absorbs = {{"lime", 0.01, 8.0}};
  catalogue.transformations = {{"rubble", "lime", 0.02, 0.5}};
  const Scene scene = grown(ground, catalogue, some(4)).scene;
  const Rules rules = compile(catalogue);
  const Environment made = make_environment(scene, rules, {ground}, 0, scene.iteration, {});
  ASSERT_EQ(made.materials.size(), 2U);
  for (size_t m = 0; m < 2; ++m) {
    const Material& of = catalogue.materials[m];
    const VectorField flow = carrying_flow(of, made, {});
    geom::Transport transport;
    transport.source = &made.sources[m];
    transport.flow = &flow;
    transport.diffusivity_m2_s = of.diffusivity_m2_s;
    transport.decay_per_s = of.decay_1_s + (m == 1 ? 0.02 : 0.0);
    const geom::MaterialBalance balance = geom::material_balance(made.materials[m], transport);
    EXPECT_GT(balance.deposited, 0.0);
    EXPECT_NEAR(balance.change(), 0.0, 0.01 * balance.deposited) << of.name;
    for (const float v : made.materials[m].cells()) ASSERT_GE(v, 0.0F);
  }
}

TEST(LifeOfObjects, SandGathersBetweenTwoIslandsAndNotAroundOne) {  // fig. 1.27
  const HeightField ground(GridFrame::centred(160, 100, 12.0), -40.0F);
  Catalogue catalogue;
  catalogue.materials = {material("sand")};
  catalogue.materials[0].diffusivity_m2_s = 3.0;
  catalogue.materials[0].decay_1_s = 1e-4;
  catalogue.materials[0].flow_coupling = 1.0;
  catalogue.classes = {region("island", "1")};
  catalogue.classes[0].deposits = {{"sand", 1e-3, 10.0}};
  catalogue.classes[0].currents = {{CurrentShape::obstacle, 0.3, 250.0}};
  const auto sand_of = [&](const std::vector<Vec2>& islands) {
    Scene scene = still_scene(ground.frame());
    scene.catalogue = catalogue;
    for (const Vec2 at : islands) add_object(scene, 0, circle(at, 200));
    return make_environment(scene, compile(catalogue), {ground}, 0, 0, {}).materials[0];
  };
  const ScalarField both = sand_of({{-330, 0}, {330, 0}}), alone = sand_of({{-330, 0}});
  const double between = mean_around(both, {0, 0}, 40);
  EXPECT_GT(between, 1.5 * mean_around(both, {-660, 0}, 40));
  EXPECT_GT(between, 1.05 * 2.0 * mean_around(alone, {0, 0}, 40));
  EXPECT_LT(mean_around(alone, {-330, 0}, 100), mean_around(alone, {-330, 280}, 40));
  const double ring = mean_around(alone, {-330, 280}, 40);
  EXPECT_NEAR(mean_around(alone, {-50, 0}, 40), ring, 0.15 * ring) << "around one it lies evenly";
}

TEST(LifeOfObjects, EnvironmentsTakeOverOnlyWhatIsTheSame) {
  const HeightField ground = shore();
  Catalogue catalogue = small_catalogue();
  catalogue.materials.push_back(material("sugar"));
  catalogue.materials[0].flow_coupling = 0.3;
  catalogue.classes[0].height = {HeightShape::bump, HeightGroup::surface, 1.0, 40.0};
  catalogue.classes[0].currents = {{CurrentShape::scale, 0.1, 30.0}};
  catalogue.classes[1].deposits = {{"sugar", 0.1, 10.0}};
  Scene scene = grown(ground, catalogue, some(3)).scene;
  scene.timeline = {StormEvent{5, 6, {0, 0}, 1.0, 0.0, 100.0}};
  const Rules rules = compile(catalogue);
  const Site site{ground};
  Environment kept = make_environment(scene, rules, site, 0, 3, {});
  const auto check = [&](double time, const char* what) {
    kept = make_environment(scene, rules, site, 0, time, {}, std::move(kept));
    const Environment anew = make_environment(scene, rules, site, 0, time, {});
    EXPECT_EQ(kept.height, anew.height) << what;
    EXPECT_EQ(kept.current, anew.current) << what;
    EXPECT_EQ(kept.materials, anew.materials) << what;
  };
  check(3, "nothing");
  check(5, "a storm");
  check(6, "no storm");
  const auto take = [&](int of_class) {
    for (size_t i = 0; i < scene.objects.size(); ++i)
      if (scene.objects[i].of_class == of_class)
        return scene.objects.erase(scene.objects.begin() + static_cast<std::ptrdiff_t>(i));
    return scene.objects.end();
  };
  take(1);
  check(6, "an alga less");
  take(0);
  check(6, "a coral less");
  scene.objects[0].skeleton.points[0].x += 7;
  check(6, "one moved");
}

}  // namespace
}  // namespace seamount::ecosystem
