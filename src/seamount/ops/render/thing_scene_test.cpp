#include "seamount/ops/render/thing_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "seamount/ops/ecosystem/place_things.h"
#include "seamount/ops/render/perspective.h"

namespace seamount::render {
namespace {

HeightField ground(int size, double cell, double height) {
  HeightField made(GridFrame{size, size, cell, 3000.0, 8000.0, {}});
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      made(x, y) = static_cast<float>(height + 0.02 * height * std::sin(0.4 * x) * std::cos(0.3 * y));
  return made;
}

Things some_things(const HeightField& terrain, int count, uint64_t seed) {
  std::vector<ecosystem::ThingSpec> specs(4);
  specs[0] = {"palm", {.shape = ThingForm::palm, .variants = 2}};
  specs[1] = {"rock", {.shape = ThingForm::rock, .height_m = 3.0}};
  specs[2] = {"fan", {.shape = ThingForm::foliose_coral, .height_m = 2.0, .variants = 2}};
  specs[3] = {"shrub", {.shape = ThingForm::shrub, .height_m = 3.0, .variants = 2}};
  Rng rng(Seed{seed});
  std::vector<ecosystem::ThingPlace> places;
  const GridFrame& f = terrain.frame();
  for (int i = 0; i < count; ++i)
    places.push_back({.place = {rng.uniform(f.west_m + 5, f.east_m() - 5), rng.uniform(f.south_m() + 5, f.north_m - 5)},
                      .spec = static_cast<uint32_t>(rng.integer(0, 3)),
                      .key = rng.bits()});
  return place_things(terrain, specs, places, {}, {seed}, {});
}

/// Every triangle of every thing, in the levels that are drawn, by itself: where a ray meets the first.
float first_of_all(const Things& things, const std::vector<uint32_t>& levels, Vec2 middle, Vec3 from, Vec3 direction,
                   float end) {
  double nearest = end;
  for (size_t i = 0; i < things.things.size(); ++i) {
    const Thing& thing = things.things[i];
    const ThingMesh& mesh = things.shapes[thing.shape].levels[levels[i]];
    const std::array<double, 3> to_foot = {thing.place.x - middle.x - from.x, thing.place.y - middle.y - from.y,
                                           thing.z_m - from.z};
    const double along = to_foot[0] * direction.x + to_foot[1] * direction.y + to_foot[2] * direction.z;
    double aside = 0;
    for (const double v : to_foot) aside += v * v;
    const double size = thing.scale * 1.5 * (things.shapes[thing.shape].height_m + things.shapes[thing.shape].radius_m);
    if (aside - along * along > size * size) continue;
    std::vector<std::array<double, 3>> world(mesh.vertex_count());
    for (size_t k = 0; k < world.size(); ++k) {
      const auto p =
          turned(thing.rotation, {mesh.positions[3 * k], mesh.positions[3 * k + 1], mesh.positions[3 * k + 2]});
      for (size_t c = 0; c < 3; ++c) world[k][c] = thing.scale * p[c] + to_foot[c];
    }
    const std::array<double, 3> d = {direction.x, direction.y, direction.z};
    for (size_t t = 0; t < mesh.indices.size(); t += 3) {
      const auto &a = world[mesh.indices[t]], &b = world[mesh.indices[t + 1]], &c = world[mesh.indices[t + 2]];
      const auto minus = [](const auto& p, const auto& q) {
        return std::array<double, 3>{p[0] - q[0], p[1] - q[1], p[2] - q[2]};
      };
      const auto crossed = [](const auto& p, const auto& q) {
        return std::array<double, 3>{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
      };
      const auto dotted = [](const auto& p, const auto& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; };
      const auto e1 = minus(b, a), e2 = minus(c, a), p = crossed(d, e2);
      const double determinant = dotted(e1, p);
      if (determinant == 0.0) continue;
      const std::array<double, 3> s = {-a[0], -a[1], -a[2]};
      const double u = dotted(s, p) / determinant;
      const auto q = crossed(s, e1);
      const double v = dotted(d, q) / determinant, at = dotted(e2, q) / determinant;
      if (u >= 0 && v >= 0 && u + v <= 1 && at > 0 && at < nearest) nearest = at;
    }
  }
  return static_cast<float>(nearest);
}

TEST(ThingScene, RaysMeetWhatTestingEveryTriangleFinds) {
  const HeightField terrain = ground(64, 4.0, 10.0);
  const Things things = some_things(terrain, 200, 3);
  const Ground drawn(terrain, nullptr, {}, {});
  const Vec2 middle{3000.0 + 128.0, 8000.0 - 128.0};
  const ThingScene scene(things, terrain, drawn, {{0.0F, 0.0F, 20.0F}, 1e-9F}, {});  // the finest levels
  const std::vector<uint32_t> levels(things.things.size(), 0);
  Rng rng(Seed{4});
  int hits = 0, different = 0;
  for (int i = 0; i < 100000; ++i) {
    const Vec3 from{static_cast<float>(rng.uniform(-120, 120)), static_cast<float>(rng.uniform(-120, 120)),
                    static_cast<float>(rng.uniform(10, 24))};
    const Vec3 direction = normalised(
        {static_cast<float>(rng.normal()), static_cast<float>(rng.normal()), static_cast<float>(0.15 * rng.normal())});
    const auto met = scene.hit(from, direction, 0.0F, 1e4F);
    EXPECT_EQ(scene.blocked(from, direction, 0.0F, 1e4F), met.has_value());
    if (met) {
      EXPECT_TRUE(scene.near(from, direction, 1e4F, 0.0F));
    }
    if (i % 20 != 0) continue;  // the judge is slow
    const float nearest = first_of_all(things, levels, middle, from, direction, 1e4F);
    hits += nearest < 1e4F ? 1 : 0;
    // A ray through an edge may miss it for one of both.
    if (std::abs((met ? met->t : 1e4F) - nearest) > 2e-3F) ++different;
  }
  EXPECT_GT(hits, 200);
  EXPECT_LE(different, 2);
}

double brightness(const Image& image, int x0, int y0, int x1, int y1) {
  double sum = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) sum += image.pixel(x, y)[0] + image.pixel(x, y)[1] + image.pixel(x, y)[2];
  return sum / ((x1 - x0) * (y1 - y0));
}

PerspectiveParams looking_down(double distance) {
  PerspectiveParams params;
  params.width_px = 160;
  params.height_px = 120;
  params.camera.distance_m = distance;
  params.camera.elevation_deg = 85.0;
  params.camera.azimuth_deg = 180.0;
  params.camera.target_x_m = 3050.0;
  params.camera.target_y_m = 7950.0;
  return params;
}

TEST(ThingsInPictures, CastShadowsAwayFromTheSun) {
  const HeightField terrain = ground(100, 1.0, 0.0);
  std::vector<ecosystem::ThingSpec> specs = {{"rock", {.shape = ThingForm::rock, .height_m = 8.0, .variants = 1}}};
  const Things one = place_things(terrain, specs, {{{3050.0, 7950.0}}}, {}, {1}, {});
  for (const double azimuth : {90.0, 270.0}) {
    PerspectiveParams params = looking_down(60.0);
    params.water = false;
    params.sun = {.azimuth_deg = azimuth, .elevation_deg = 30.0};
    const Image bare = perspective(terrain, nullptr, params, {}),
                with = perspective(terrain, {.things = &one}, params, {});
    const auto change = [&](int x0, int x1) {
      return brightness(with, x0, 55, x1, 65) / brightness(bare, x0, 55, x1, 65);
    };
    const double west = change(40, 58), east = change(102, 120);
    EXPECT_LT(azimuth == 90.0 ? west : east, 0.8) << "in the shadow";
    EXPECT_GT(azimuth == 90.0 ? east : west, 0.95) << "in the sun";
  }
}

TEST(ThingsInPictures, AreTheSameOnAnyThreadsAndNothingWithoutThings) {
  const HeightField terrain = ground(64, 4.0, 6.0);
  const Things things = some_things(terrain, 200, 5);
  PerspectiveParams params;
  params.width_px = 200;
  params.height_px = 120;
  RunContext one, many;
  one.threads = 1;
  many.threads = 5;
  const Image a = perspective(terrain, {.things = &things}, params, one);
  EXPECT_EQ(a, perspective(terrain, {.things = &things}, params, many));
  const Things none;
  EXPECT_EQ(perspective(terrain, {.things = &none}, params, one), perspective(terrain, nullptr, params, one));
  EXPECT_NE(a, perspective(terrain, nullptr, params, one));
}

TEST(ThingsInPictures, OddTerrainsAndPlacesAreDrawn) {
  PerspectiveParams params;
  params.width_px = 48;
  params.height_px = 32;
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {7, 1}}) {
    const HeightField terrain(GridFrame{width, height, 5.0, 0.0, 50.0, {}}, 3.0F);
    const Things one =
        ecosystem::place_things(terrain, {{"rock", {.shape = ThingForm::rock}}}, {{{2.5, 47.5}}}, {}, {1}, {});
    ASSERT_EQ(one.things.size(), 1U);
    EXPECT_EQ(perspective(terrain, {.things = &one}, params, {}).width, 48);
  }
  HeightField holes = ground(32, 4.0, 8.0);
  for (int y = 8; y < 24; ++y)
    for (int x = 8; x < 24; ++x) holes(x, y) = std::numeric_limits<float>::quiet_NaN();
  Things things = some_things(holes, 80, 2);
  EXPECT_LT(things.things.size(), 80U);
  things.things[0].place = {-5e5, 3e5};  // far away, and where nothing is known
  things.things[1].place = {3000.0 + 64.0, 8000.0 - 64.0};
  EXPECT_EQ(perspective(holes, {.things = &things}, params, {}), perspective(holes, {.things = &things}, params, {}));
}

TEST(ThingsInPictures, AreSeenThroughTheWaterAndBluerTheDeeper) {
  std::array<double, 2> red{}, blue{};
  for (size_t k = 0; k < 2; ++k) {
    const HeightField terrain = ground(100, 1.0, k == 0 ? -2.0 : -8.0);
    std::vector<ecosystem::ThingSpec> specs = {{"dome",
                                                {.shape = ThingForm::massive_coral,
                                                 .height_m = 1.5,
                                                 .width_m = 16.0,
                                                 .variants = 1,
                                                 .colour = {200, 190, 170}}}};
    const Things one = place_things(terrain, specs, {{{3050.0, 7950.0}}}, {}, {1}, {});
    const Image bare = perspective(terrain, nullptr, looking_down(40.0), {}),
                with = perspective(terrain, {.things = &one}, looking_down(40.0), {});
    EXPECT_GT(std::abs(brightness(with, 70, 50, 90, 70) - brightness(bare, 70, 50, 90, 70)), 5.0);
    red[k] = with.pixel(80, 60)[0];
    blue[k] = with.pixel(80, 60)[2];
  }
  EXPECT_LT(red[1] / blue[1], 0.7 * red[0] / blue[0]);
}

TEST(Underwater, FarSandIsTheWatersBlueAndTheSurfaceStandsAbove) {
  HeightField terrain(GridFrame{200, 200, 1.0, 0.0, 200.0, {}}, -6.0F);
  PerspectiveParams params;
  params.width_px = 160;
  params.height_px = 120;
  params.surround = Surround::sea;
  params.camera.distance_m = 6.0;
  params.camera.elevation_deg = 10.0;
  params.camera.azimuth_deg = 180.0;
  params.camera.target_x_m = 100.0;
  params.camera.target_y_m = 60.0;
  params.camera.field_of_view_deg = 70.0;
  const Image image = perspective(terrain, nullptr, params, {});
  const auto ratio = [&](int y) { return (1.0 + image.pixel(80, y)[0]) / (1.0 + image.pixel(80, y)[2]); };
  EXPECT_GT(ratio(110), 1.5 * ratio(50)) << "near sand has red, far water has none";
  for (const int y : {2, 40, 60, 110}) EXPECT_GT(image.pixel(80, y)[2], 60) << "nothing is black";
  // From above, the same place is a sea.
  params.camera.elevation_deg = 60.0;
  params.camera.distance_m = 30.0;
  EXPECT_NE(perspective(terrain, nullptr, params, {}), image);
}

TEST(NearCamera, NeedsADistanceToLookUp) {
  const HeightField terrain = ground(32, 4.0, 10.0);
  PerspectiveParams params;
  params.camera.elevation_deg = -10.0;
  EXPECT_THROW(perspective(terrain, nullptr, params, {}), InvalidArgument);
  params.camera.distance_m = 20.0;
  params.camera.target_height_m = 15.0;
  params.width_px = params.height_px = 32;
  EXPECT_EQ(perspective(terrain, nullptr, params, {}).width, 32);
}

}  // namespace
}  // namespace seamount::render
