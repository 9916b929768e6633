#include "seamount/ops/ecosystem/place_things.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/geom/things/make_thing.h"
#include "seamount/model/sample_known.h"

namespace seamount::ecosystem {
namespace {

/// A slope towards east with a bump, and a hole.
HeightField terrain(double slope) {
  HeightField heights(GridFrame{60, 40, 5.0, 1000.0, 9000.0, "EPSG:32627"});
  for (int y = 0; y < heights.height(); ++y)
    for (int x = 0; x < heights.width(); ++x)
      heights(x, y) = static_cast<float>(3.0 + slope * 5.0 * x + 2.0 * std::sin(0.3 * y));
  heights(30, 20) = heights(31, 20) = heights(30, 21) = heights(31, 21) = std::numeric_limits<float>::quiet_NaN();
  return heights;
}

std::vector<ThingSpec> specs() {
  std::vector<ThingSpec> all(3);
  all[0] = {"palm", {.shape = ThingForm::palm}};
  all[1] = {"rock", {.shape = ThingForm::rock, .size_variation = 0.0}};
  all[2] = {"coral", {.shape = ThingForm::table_coral, .height_m = 0.5, .variants = 2}};
  return all;
}

std::vector<ThingPlace> placements(int count, uint64_t seed) {
  Rng rng(Seed{seed});
  std::vector<ThingPlace> all;
  for (int i = 0; i < count; ++i) {
    ThingPlace p;
    p.place = {rng.uniform(1002.5, 1297.5), rng.uniform(8802.5, 8997.5)};
    p.spec = static_cast<uint32_t>(rng.integer(0, 2));
    p.health = rng.uniform();
    p.size = rng.uniform(0.5, 2.0);
    p.key = rng.bits();
    all.push_back(p);
  }
  return all;
}

TEST(PlaceThings, StandOnTheGroundAndNeverFloat) {
  for (const double slope : {0.0, 0.3, 0.9}) {
    const HeightField ground = terrain(slope);
    const auto where = placements(500, 3);
    const Things all = place_things(ground, specs(), where, {}, {1}, {});
    EXPECT_EQ(all.crs, "EPSG:32627");
    EXPECT_EQ(all.ground.frame(), ground.frame());
    for (const Thing& thing : all.things) {
      const ThingShape& shape = all.shapes[thing.shape];
      const double z = sample_known(ground, ground.frame().column(thing.place.x), ground.frame().row(thing.place.y));
      EXPECT_LE(thing.z_m, z);
      EXPECT_GE(thing.z_m, z - 0.75 * thing.scale * (shape.height_m + shape.foot_m));
      for (int k = 0; k < 8; ++k) {  // the foot's edge is in the ground
        const double angle = k * std::numbers::pi / 4, r = 0.98 * shape.foot_m;
        const auto edge = turned(thing.rotation, {r * std::cos(angle), r * std::sin(angle), 0.0});
        const double x = thing.place.x + thing.scale * edge[0], y = thing.place.y + thing.scale * edge[1];
        const double below = sample_known(ground, ground.frame().column(x), ground.frame().row(y));
        if (!std::isnan(below)) {
          EXPECT_LT(thing.z_m + thing.scale * edge[2], below + 0.12 * thing.scale * shape.foot_m) << shape.name;
        }
      }
    }
  }
}

TEST(PlaceThings, RocksLeanWithTheGroundAndPalmsStandUpright) {
  HeightField plane(GridFrame::centred(20, 20, 10.0), 0.0F);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) plane(x, y) = 4.0F * static_cast<float>(x) + 2.0F * static_cast<float>(y);
  // dz/dx = 0.4, dz/dy (north) = -0.2
  std::vector<ThingPlace> where = {{{0.0, 0.0}, 0}, {{5.0, 3.0}, 1}};
  const Things all = place_things(plane, specs(), where, {}, {2}, {});
  const auto palm = turned(all.things[0].rotation, {0.0, 0.0, 1.0}),
             rock = turned(all.things[1].rotation, {0.0, 0.0, 1.0});
  EXPECT_NEAR(palm[2], 1.0, 1e-6);
  const double n = std::sqrt(1.0 + 0.16 + 0.04);
  EXPECT_NEAR(rock[0], -0.4 / n, 1e-5);
  EXPECT_NEAR(rock[1], 0.2 / n, 1e-5);
  EXPECT_NEAR(rock[2], 1.0 / n, 1e-5);
}

TEST(PlaceThings, HeadingsTurnClockwiseFromNorth) {
  const HeightField level(GridFrame::centred(20, 20, 10.0), 5.0F);
  const std::vector<ThingPlace> where = {{{0.0, 0.0}, 0, 1.0, 90.0}, {{0.0, 0.0}, 1, 1.0, 0.0}};
  const Things all = place_things(level, specs(), where, {}, {2}, {});
  const auto east = turned(all.things[0].rotation, {0.0, 1.0, 0.0}),
             north = turned(all.things[1].rotation, {0.0, 1.0, 0.0});
  EXPECT_NEAR(east[0], 1.0, 1e-6);
  EXPECT_NEAR(north[1], 1.0, 1e-6);
}

TEST(PlaceThings, AreTheSameOnAnyThreadsAndByThemselves) {
  const HeightField ground = terrain(0.2);
  const auto where = placements(10000, 8);
  RunContext one, many;
  one.threads = 1;
  many.threads = 7;
  const Things a = place_things(ground, specs(), where, {}, {5}, one),
               b = place_things(ground, specs(), where, {}, {5}, many);
  EXPECT_EQ(a.things, b.things);
  EXPECT_EQ(a.shapes, b.shapes);
  EXPECT_NE(a.things, place_things(ground, specs(), where, {}, {6}, one).things);
  const std::vector<ThingPlace> alone = {where[4711]};
  const Things c = place_things(ground, specs(), alone, {}, {5}, {});
  const auto same =
      std::find_if(a.things.begin(), a.things.end(), [&](const Thing& thing) { return thing.place == alone[0].place; });
  ASSERT_NE(same, a.things.end());
  Thing renumbered = *same;
  renumbered.shape = 0;
  EXPECT_EQ(c.things[0], renumbered);
  EXPECT_EQ(c.shapes[0], a.shapes[same->shape]);
}

TEST(PlaceThings, SayWhatIsLeftOut) {
  const HeightField ground = terrain(0.0);
  std::vector<ThingPlace> where = {{{1010.0, 8900.0}, 1}, {{900.0, 8900.0}, 1}, {{1155.0, 8895.0}, 1}};
  std::string said;
  RunContext run;
  run.note = [&](const std::string& line) { said += line; };
  EXPECT_EQ(place_things(ground, specs(), where, {}, {1}, run).things.size(), 1U);
  EXPECT_THAT(said, ::testing::HasSubstr("2 of 3 things left out"));
}

TEST(PlaceThings, KeepABudgetOfTriangles) {
  const HeightField ground = terrain(0.1);
  const auto where = placements(300, 2);
  const Things all = place_things(ground, specs(), where, {}, {1}, {});
  uint64_t before = 0;
  for (const uint64_t most :
       {uint64_t{2000}, uint64_t{9000}, uint64_t{40000}, uint64_t{100000}, all.triangle_count()}) {
    std::string said;
    RunContext run;
    run.note = [&](const std::string& line) { said += line + "\n"; };
    const Things fewer = place_things(ground, specs(), where, {.max_triangles = most}, {1}, run);
    EXPECT_LE(fewer.triangle_count(), most);
    EXPECT_GE(fewer.triangle_count(), before);
    EXPECT_GE(fewer.triangle_count(), most / 2);
    before = fewer.triangle_count();
    EXPECT_EQ(said.empty(), most == all.triangle_count());
    EXPECT_EQ(fewer.things.size() < all.things.size(), said.find("are left") != std::string::npos);
  }
}

TEST(PlaceThings, RefuseWhatMakesNoSense) {
  const HeightField ground = terrain(0.1);
  const auto refusal = [&](const std::vector<ThingSpec>& kinds, const ThingPlace& p) -> std::string {
    try {
      place_things(ground, kinds, {p}, {}, {1}, {});
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(specs(), {{1010.0, 8900.0}, 3}), "placements: 0: spec 3 of 3");
  EXPECT_EQ(refusal(specs(), {{1010.0, 8900.0}, 1, 0.0}), "placements: 0: size 0 is not above 0");
  EXPECT_EQ(refusal(specs(), {{std::nan(""), 8900.0}, 1}), "placements: 0: its place is no number");
  auto kinds = specs();
  kinds[1].params.shape = ThingForm::file;
  EXPECT_EQ(refusal(kinds, {{1010.0, 8900.0}, 0}), "specs[1].mesh: shape file needs the mesh of a file");
  kinds = specs();
  kinds[0].params.variants = 0;
  EXPECT_EQ(refusal(kinds, {{1010.0, 8900.0}, 0}), "specs[0].variants: 0 is outside [1, 64]");
}

}  // namespace
}  // namespace seamount::ecosystem
