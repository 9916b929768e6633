#include "seamount/ops/render/perspective.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "seamount/ops/render/test_terrain.h"

namespace seamount::render {
namespace {

PerspectiveParams small() {
  PerspectiveParams params;
  params.width_px = 160;
  params.height_px = 90;
  return params;
}

TEST(Perspective, SameBytesForAnyNumberOfThreads) {
  const HeightField terrain = test_island(150, 130, 20000.0, 1200.0);
  const LabelMap labels = test_labels(terrain);
  EXPECT_EQ(perspective(terrain, &labels, small(), {.threads = 1}),
            perspective(terrain, &labels, small(), {.threads = 2}));
}

TEST(Perspective, ShowsSkyOverSeaWhenTheCameraIsLow) {
  const HeightField terrain = test_island(128, 128, 20000.0, 1200.0);
  PerspectiveParams params = small();
  params.camera.elevation_deg = 8.0;
  const Image image = perspective(terrain, nullptr, params, {});
  const Colour sky = image.colour(80, 2), sea = image.colour(80, 87);
  EXPECT_GT(sky.r + sky.g + sky.b, 330);
  EXPECT_GT(sea.b, sea.r + 25);
  EXPECT_LT(sea.r + sea.g + sea.b, sky.r + sky.g + sky.b);
}

TEST(Perspective, WaterCanBeLeftOut) {
  const HeightField terrain = test_island(96, 96, 20000.0, 0.0);
  PerspectiveParams dry = small();
  dry.water = false;
  int blue = 0;
  const Image image = perspective(terrain, nullptr, dry, {});
  for (int y = 30; y < 60; ++y) {
    for (int x = 60; x < 100; ++x) blue += image.colour(x, y).b > image.colour(x, y).r + 25 ? 1 : 0;
  }
  EXPECT_LT(blue, 120);
}

TEST(Perspective, TheSunLightsTheSideItStandsOn) {
  // A long ridge from south to north, seen from the south.
  HeightField ridge(GridFrame::centred(80, 80, 100.0));
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 80; ++x) ridge(x, y) = 2000.0F - 60.0F * std::abs(static_cast<float>(x) - 39.5F) + 500.0F;
  }
  PerspectiveParams params = small();
  params.camera.azimuth_deg = 180.0;
  params.camera.elevation_deg = 60.0;
  const auto brightness = [&](double azimuth, int x) {
    params.sun.azimuth_deg = azimuth;
    const Colour c = perspective(ridge, nullptr, params, {}).colour(x, 40);
    return c.r + c.g + c.b;
  };
  EXPECT_GT(brightness(270.0, 65), brightness(270.0, 95) + 60);
  EXPECT_GT(brightness(90.0, 95), brightness(90.0, 65) + 60);
}

TEST(Perspective, AgainstTheSunTheSeaIsNotWhite) {
  const HeightField terrain = test_island(128, 128, 20000.0, 900.0);
  for (const double elevation : {5.0, 12.0, 30.0, 50.0, 80.0}) {
    for (const double camera : {12.0, 25.0, 45.0}) {
      PerspectiveParams params = small();
      params.sun = {.azimuth_deg = 285.0, .elevation_deg = elevation};
      params.camera.azimuth_deg = 105.0;
      params.camera.elevation_deg = camera;
      const Image image = perspective(terrain, nullptr, params, {});
      int white = 0;
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
          const Colour c = image.colour(x, y);
          white += std::min({c.r, c.g, c.b}) >= 248 ? 1 : 0;
        }
      EXPECT_LT(white, image.width * image.height / 500) << elevation << " " << camera;
    }
  }
}

TEST(Perspective, MountainsStandAgainstTheSky) {
  // Seen from low over the sea, the skyline is the mountain's, not a level line.
  HeightField cone(GridFrame::centred(128, 128, 100.0));
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x)
      cone(x, y) = 1500.0F - 30.0F * std::hypot(static_cast<float>(x) - 63.5F, static_cast<float>(y) - 63.5F);
  PerspectiveParams params = small();
  params.camera = {.azimuth_deg = 180.0, .elevation_deg = 3.0, .target_x_m = 0.0, .target_y_m = -6300.0};
  params.camera.distance_m = 9000.0;
  const Image image = perspective(cone, nullptr, params, {});
  const auto skyline = [&](int x) {
    int y = 0;
    while (y < image.height && luminance(linear(image.colour(x, y))) > 0.25F) ++y;
    return y;
  };
  EXPECT_LT(skyline(80), skyline(60) - 3);
  EXPECT_LT(skyline(60), skyline(30) - 3);
  EXPECT_NEAR(skyline(60), skyline(100), 3);
}

TEST(Perspective, TheSeaFloorGoesOnBeyondTheBorder) {
  for (const float floor : {-4.0F, -13.0F, -40.0F}) {
    HeightField shelf(GridFrame::centred(128, 128, 40.0), floor);
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 128; ++x) shelf(x, y) += 0.02F * static_cast<float>((x * 7 + y * 13) % 10);  // no flat model
    PerspectiveParams params = small();
    params.haze = 0.0;
    params.camera.elevation_deg = 60.0;
    params.camera.azimuth_deg = 180.0;
    params.camera.distance = 2.0;
    const Image image = perspective(shelf, nullptr, params, {});
    const auto column = [&](int x) {
      Rgb sum;
      for (int y = 35; y < 55; ++y) sum += linear(image.colour(x, y));
      return 0.05F * sum;
    };
    // The terrain ends near a quarter and three quarters of the picture's width: no step there, and none anywhere.
    for (int x = 2; x + 4 < image.width; ++x) {
      EXPECT_NEAR(column(x).g, column(x + 2).g, 0.08F * column(x).g) << floor << " at " << x;
      EXPECT_NEAR(column(x).b, column(x + 2).b, 0.08F * column(x).b) << floor << " at " << x;
    }
    EXPECT_NEAR(column(8).b, column(80).b, 0.35F * column(80).b) << floor;
  }
}

TEST(Perspective, OddTerrainsAndCamerasAreDrawn) {
  for (const auto& [w, h] : {std::pair{1, 1}, {1, 9}, {40, 3}}) {
    for (const float height : {-50.0F, 0.0F, 300.0F}) {
      const HeightField terrain(GridFrame::centred(w, h, 30.0), height);
      const Image image = perspective(terrain, nullptr, small(), {});
      EXPECT_EQ(image.width, 160);
    }
  }
  const HeightField terrain = test_alps(64, 64, 9000.0);
  for (const double elevation : {1.0, 89.0}) {
    for (const double distance : {0.02, 10.0}) {
      PerspectiveParams params = small();
      params.camera.elevation_deg = elevation;
      params.camera.distance = distance;
      EXPECT_EQ(perspective(terrain, nullptr, params, {}).height, 90);
    }
  }
}

TEST(Perspective, RefusesWhatItCannotDraw) {
  HeightField terrain(GridFrame::centred(4, 4, 10.0), 1.0F);
  PerspectiveParams params = small();
  params.haze = -1.0;
  EXPECT_THROW(perspective(terrain, nullptr, params, {}), InvalidArgument);
  const LabelMap labels(GridFrame::centred(5, 4, 10.0), Region::reef);
  EXPECT_THROW(perspective(terrain, &labels, small(), {}), IncompatibleInputs);
  terrain(2, 1) = std::numeric_limits<float>::infinity();
  EXPECT_THROW(perspective(terrain, nullptr, small(), {}), InvalidArgument);
  EXPECT_THROW(perspective(HeightField(), nullptr, small(), {}), InvalidArgument);
  const std::atomic<bool> stop = true;
  EXPECT_THROW(perspective(test_alps(8, 8, 900.0), nullptr, small(), {.cancelled = &stop}), Cancelled);
}

}  // namespace
}  // namespace seamount::render
