#include "seamount/ops/render/place_camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/ops/render/perspective.h"
#include "seamount/ops/render/subject.h"
#include "seamount/ops/render/test_terrain.h"

namespace seamount::render {
namespace {

/// A bowl 500 m deep in a plain, 6 km across.
HeightField bowl() {
  HeightField terrain(GridFrame::centred(200, 200, 50.0));
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) {
      const double r = std::hypot(terrain.frame().x(x), terrain.frame().y(y));
      terrain(x, y) = static_cast<float>(1000.0 + 500.0 * std::clamp((r - 1500.0) / 1500.0, 0.0, 1.0));
    }
  return terrain;
}

PerspectiveParams small() {
  PerspectiveParams params;
  params.width_px = 160;
  params.height_px = 90;
  return params;
}

TEST(PlaceCamera, FromWithinABowlItsWallsAreWhole) {
  const HeightField terrain = bowl();
  for (const double azimuth : {0.0, 45.0, 90.0, 160.0, 300.0}) {
    PerspectiveParams params = small();
    params.camera = {.x_m = 0.0, .y_m = 0.0, .height_m = 50.0};
    params.camera.target_x_m = 1000.0 * std::sin(azimuth);
    params.camera.target_y_m = 1000.0 * std::cos(azimuth);
    params.camera.target_height_m = 50.0;  // level
    const Image image = perspective(terrain, nullptr, params, {});
    // The rim stands 450 m over the eye at 3 km: at tan 0.15, where half the picture is tan 17.5 degrees.
    const int rim = static_cast<int>(45.0 - 45.0 * 0.15 / std::tan(17.5 * std::numbers::pi / 180.0));
    for (int x = 0; x < 160; x += 5) {
      const Colour above = image.colour(x, 4), wall = image.colour(x, rim + 4);
      EXPECT_GT(above.b, above.g) << x;  // sky
      EXPECT_LT(wall.b, wall.g) << x;    // ground
    }
  }
}

TEST(PlaceCamera, StandsWhereItIsTold) {
  const HeightField terrain = bowl();
  const Ground ground(terrain, nullptr, {}, {});
  for (const double height : {2.0, 300.0}) {
    const Camera camera =
        place_camera({.x_m = 4000.0, .y_m = -1000.0, .height_m = height}, {.sea = false}, terrain.frame(), ground);
    EXPECT_NEAR(camera.position.x, 4000.0, 1.0);
    EXPECT_NEAR(camera.position.y, -1000.0, 1.0);
    EXPECT_NEAR(camera.position.z, 1500.0 + height, 1.0);
  }
  // Over water the height is over the water.
  const HeightField sea(GridFrame::centred(50, 50, 100.0), -200.0F);
  const Camera boat = place_camera({.x_m = 100.0, .y_m = 100.0, .height_m = 3.0}, {.sea = true}, sea.frame(),
                                   Ground(sea, nullptr, {}, {}));
  EXPECT_NEAR(boat.position.z, 3.0, 1e-3);
}

TEST(PlaceCamera, ATurntableKeepsItsDistance) {
  const HeightField terrain = test_island(128, 128, 20000.0, 1200.0);
  const Ground ground(terrain, nullptr, {}, {});
  float least = 1e9F, most = 0.0F;
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += 24.0) {
    const Camera camera =
        place_camera({.view = CameraView::turntable, .azimuth_deg = azimuth}, {.sea = true}, terrain.frame(), ground);
    const std::vector<Vec3> all = all_places_to_show(ground, true, 0.0F);
    const float out = std::hypot(camera.position.x, camera.position.y);
    least = std::min(least, out);
    most = std::max(most, out);
    for (const Vec3& place : all) {  // and all is in the picture
      const Vec3 way = place - camera.position;
      const float depth = dot(way, camera.forward);
      EXPECT_LE(std::abs(dot(way, camera.up)), depth * camera.tan_half_height);
      EXPECT_LE(std::abs(dot(way, camera.right)), depth * camera.tan_half_height * 1280.0F / 720.0F);
    }
  }
  EXPECT_LT(most - least, 0.15F * most);  // the target is not the terrain's middle
}

TEST(PlaceCamera, InACanyonTheEyeIsBelowTheGroundAround) {
  for (const double size : {6000.0, 24000.0}) {
    const HeightField terrain = test_alps(200, 160, size);
    const Ground ground(terrain, nullptr, {}, {});
    const Camera camera = place_camera({.view = CameraView::canyon}, {}, terrain.frame(), ground);
    const float here = ground.form(camera.position.x, camera.position.y, 1.0F).height;
    EXPECT_GT(camera.position.z, here);
    int higher = 0;
    for (int k = 0; k < 16; ++k) {
      const auto angle = static_cast<float>(k) * 0.3927F, way = static_cast<float>(0.05 * size);
      higher += ground.form(camera.position.x + way * std::sin(angle), camera.position.y + way * std::cos(angle), 1.0F)
                            .height > camera.position.z
                    ? 1
                    : 0;
    }
    EXPECT_GE(higher, 6);
    // Twice as high over the floor, and half.
    for (const double distance : {0.5, 2.0}) {
      const Camera other =
          place_camera({.view = CameraView::canyon, .distance = distance}, {}, terrain.frame(), ground);
      EXPECT_EQ(other.position.x, camera.position.x);
      EXPECT_EQ(other.position.z > camera.position.z, distance > 1.0);
      EXPECT_GT(other.position.z, here);
    }
  }
}

TEST(PlaceCamera, RefusesWhatContradictsItself) {
  const auto field_of = [](const CameraParams& params) {
    try {
      check_camera(params);
    } catch (const InvalidArgument& error) {
      return std::string(error.what()).substr(0, std::string(error.what()).find(':'));
    }
    return std::string("none");
  };
  EXPECT_EQ(field_of({.x_m = 1.0}), "camera.y_m");
  EXPECT_EQ(field_of({.y_m = 1.0}), "camera.x_m");
  EXPECT_EQ(field_of({.distance_m = 10.0, .x_m = 1.0, .y_m = 1.0}), "camera.distance_m");
  EXPECT_EQ(field_of({.elevation_deg = -5.0}), "camera.elevation_deg");
  EXPECT_EQ(field_of({.view = CameraView::canyon, .elevation_deg = -5.0}), "none");
  EXPECT_EQ(field_of({}), "none");
}

TEST(PlaceCamera, AnEveningIsWarmAndNotDark) {
  HeightField sea(GridFrame::centred(64, 64, 100.0), -50.0F);
  sea(32, 32) = 40.0F;
  const auto picture = [&](Daylight light, double towards_deg) {
    PerspectiveParams params = small();
    params.sun.light = light;
    params.camera = {.view = CameraView::hero, .azimuth_deg = towards_deg - 180.0};
    return perspective(sea, nullptr, params, {});
  };
  const auto mean = [](const Image& image, int y0, int y1) {
    Rgb sum;
    for (int y = y0; y < y1; ++y)
      for (int x = 0; x < image.width; ++x) sum += linear(image.colour(x, y));
    return (1.0F / static_cast<float>((y1 - y0) * image.width)) * sum;
  };
  const Rgb noon = mean(picture(Daylight::noon, 275.0), 0, 10),
            evening = mean(picture(Daylight::evening, 275.0), 0, 10);
  EXPECT_GT(noon.b, noon.r);
  EXPECT_GT(evening.r, 1.1F * evening.b);
  const float day = luminance(mean(picture(Daylight::afternoon, 30.0), 0, 90)),
              dusk = luminance(mean(picture(Daylight::evening, 30.0), 0, 90));
  EXPECT_GT(dusk, 0.4F * day);
  EXPECT_LT(dusk, 1.1F * day);
}

}  // namespace
}  // namespace seamount::render
