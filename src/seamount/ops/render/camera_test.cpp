#include "seamount/ops/render/camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace seamount::render {
namespace {

/// Where a point is in the picture, in pixels; the inverse of Camera::direction.
std::pair<float, float> project(const Camera& camera, Vec3 point) {
  const Vec3 d = point - camera.position;
  const float scale = camera.height_px / (2.0F * camera.tan_half_height * dot(d, camera.forward));
  return {0.5F * camera.width_px + scale * dot(d, camera.right), 0.5F * camera.height_px - scale * dot(d, camera.up)};
}

const std::vector<Vec3> kBlock = {{-5000, -4000, 0},   {5000, -4000, 0},   {5000, 4000, 0},   {-5000, 4000, 0},
                                  {-5000, -4000, 900}, {5000, -4000, 900}, {5000, 4000, 900}, {-5000, 4000, 900}};

TEST(Camera, ShowsEveryPointWithoutMuchWaste) {
  for (const double azimuth : {0.0, 0.8, 3.6, 5.5}) {
    for (const double elevation : {0.2, 0.45, 1.2}) {
      const View view{.azimuth = azimuth, .elevation = elevation, .field_of_view = 0.61};
      const Camera camera = fit_camera(view, {0, 0, 300}, kBlock);
      float widest = 0.0F;
      for (const Vec3& point : kBlock) {
        const auto [x, y] = project(camera, point);
        EXPECT_GE(x, 0.0F);
        EXPECT_LE(x, 1280.0F);
        EXPECT_GE(y, 0.0F);
        EXPECT_LE(y, 720.0F);
        widest = std::max({widest, std::abs(x - 640.0F) / 640.0F, std::abs(y - 360.0F) / 360.0F});
      }
      EXPECT_GE(widest, 0.85F);
      EXPECT_NEAR(dot(camera.forward, camera.up), 0.0F, 1e-6F);
      EXPECT_NEAR(dot(camera.forward, camera.right), 0.0F, 1e-6F);
    }
  }
}

TEST(Camera, StandsOnTheBearingItIsGiven) {
  const Camera camera = fit_camera({.azimuth = std::acos(-1.0) / 2.0, .elevation = 0.4}, {0, 0, 0}, kBlock);
  EXPECT_GT(camera.position.x, 5000.0F);  // from the east
  EXPECT_NEAR(camera.position.y, 0.0F, 10.0F);
  EXPECT_NEAR(std::atan2(camera.position.z, camera.position.x), 0.4F, 1e-4F);
}

}  // namespace
}  // namespace seamount::render
