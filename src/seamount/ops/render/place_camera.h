// Where the camera of a perspective picture stands and what it looks at, from what its parameters say.
#pragma once

#include "seamount/ops/render/camera.h"
#include "seamount/ops/render/ground.h"
#include "seamount/ops/render/view_params.h"

namespace seamount::render {

/// What else the camera must know of the picture.
struct Stage {
  int width_px = 1280, height_px = 720;
  bool sea = false;     ///< the water goes on beyond the terrain
  bool water = true;    ///< ground below 0 is under it
  float base_m = 0.0F;  ///< height of the table under a block
};

/// Throws InvalidArgument where parameters contradict each other: one of x_m and y_m alone, a place and a distance, a
/// camera at or below the horizon that has no place.
void check_camera(const CameraParams& params);

/// `frame` tells where the ground's middle lies. Above ground always, above water but with distance_m or a place.
Camera place_camera(const CameraParams& params, const Stage& stage, const GridFrame& frame, const Ground& ground);

/// The latitude says on which side the sun stands at noon.
SunDirection sun_direction(const SunParams& params, double latitude_deg);

}  // namespace seamount::render
