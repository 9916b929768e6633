// A pinhole camera without roll, and where to put it so that a terrain fills the picture.
#pragma once

#include <vector>

#include "seamount/ops/render/sky.h"

namespace seamount::render {

/// Metres from the terrain's middle; x east, y north, z over the water.
struct Camera {
  Vec3 position;
  Vec3 forward, right, up;
  float tan_half_height = 0.3F;  ///< of the angle of view from top to bottom
  float width_px = 1.0F, height_px = 1.0F;

  /// Unit direction through a place of the picture in pixels, (0, 0) the top left corner.
  Vec3 direction(float x, float y) const {
    const float scale = 2.0F * tan_half_height / height_px;
    return normalised(forward + (scale * (x - 0.5F * width_px)) * right - (scale * (y - 0.5F * height_px)) * up);
  }
  /// Angle that a pixel covers, radians.
  float pixel_angle() const { return 2.0F * tan_half_height / height_px; }
};

struct View {
  double azimuth = 0.0;        ///< bearing of the camera from the target, radians
  double elevation = 0.5;      ///< radians
  double field_of_view = 0.6;  ///< from top to bottom, radians
  double distance = 1.0;       ///< factor on the fitted distance
  int width_px = 1280, height_px = 720;
  bool horizon = false;  ///< keep a strip of sky in the picture
};

/// A camera that looks at `target` from the view's side, at the least distance at which all `points` are in the picture
/// with a small margin, times view.distance. REQUIRES: points not empty.
Camera fit_camera(const View& view, Vec3 target, const std::vector<Vec3>& points);

/// A camera at a distance from a target that it looks at, from the view's side and height. REQUIRES: distance > 0.
Camera aim_camera(const View& view, Vec3 target, double distance);
/// The camera where it is, turned to a target, which is not straight above or below it.
Camera turn_camera(Camera camera, Vec3 target);

}  // namespace seamount::render
