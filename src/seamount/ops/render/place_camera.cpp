#include "seamount/ops/render/place_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/ops/render/subject.h"

namespace seamount::render {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// What a view takes where nothing is said.
struct Usual {
  double azimuth_deg, elevation_deg, field_of_view_deg;
};

Usual usual(CameraView view) {
  switch (view) {
    case CameraView::hero:
      return {205.0, 7.0, 28.0};
    case CameraView::canyon:
      return {205.0, 0.0, 60.0};
    case CameraView::turntable:
      return {205.0, 30.0, 35.0};
    default:
      return {205.0, 25.0, 35.0};
  }
}

/// The middle of the places' extent, at a height of the lower part of the terrain.
Vec3 middle(const std::vector<Vec3>& places) {
  Vec3 low = places.front(), high = low;
  for (const Vec3& p : places) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return {0.5F * (low.x + high.x), 0.5F * (low.y + high.y), low.z + 0.3F * (high.z - low.z)};
}

/// A drum around all places: it looks the same from every side.
std::vector<Vec3> drum_around(const std::vector<Vec3>& places) {
  const Vec3 centre = middle(places);
  float radius = 0.0F, low = places.front().z, high = low;
  for (const Vec3& p : places) {
    radius = std::max(radius, std::hypot(p.x - centre.x, p.y - centre.y));
    low = std::min(low, p.z);
    high = std::max(high, p.z);
  }
  std::vector<Vec3> drum;
  constexpr int kSides = 64;
  for (int i = 0; i < kSides; ++i) {
    const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / kSides;
    drum.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle), low});
  }
  drum.push_back({centre.x, centre.y, high});
  return drum;
}

/// A place of the document, in metres from the ground's middle.
Vec3 place_at(double x_m, double y_m, const GridFrame& frame) {
  return {static_cast<float>(x_m - (frame.west_m + 0.5 * frame.width_m())),
          static_cast<float>(y_m - (frame.north_m - 0.5 * frame.height_m())), 0.0F};
}

float ground_at(const Ground& ground, Vec3 place) {
  return ground.form(place.x, place.y, 1e-3F * ground.cell_m()).height;
}

/// Neither in nor out of the water is no place for an eye.
Vec3 off_the_surface(Vec3 place, const Stage& stage, const Ground& ground) {
  constexpr float kOfSurface = 0.02F;
  if (stage.water && std::abs(place.z) < kOfSurface && !ground.is_dry(place.x, place.y))
    place.z = place.z < 0.0F ? -kOfSurface : kOfSurface;
  return place;
}

/// A camera so many metres from a place on the ground, that it looks at. Over ground, in water or over it.
Camera near_camera(const CameraParams& params, const Stage& stage, const View& view, const Ground& ground,
                   Vec3 target) {
  target.z = ground_at(ground, target) + static_cast<float>(params.target_height_m);
  Camera camera = aim_camera(view, target, *params.distance_m);
  const float floor = std::max(ground_at(ground, camera.position), stage.sea ? -1e9F : stage.base_m);
  const auto clear = static_cast<float>(std::clamp(0.04 * *params.distance_m, 0.05, 2.0));
  if (camera.position.z < floor + clear) {
    camera.position.z = floor + clear;
    camera = turn_camera(camera, target);
  }
  camera.position = off_the_surface(camera.position, stage, ground);
  return camera;
}

/// A camera that stands somewhere, over ground and water.
Camera standing_camera(const CameraParams& params, const Stage& stage, const View& view, const Ground& ground,
                       Vec3 place, Vec3 target) {
  const float floor = ground_at(ground, place);
  const bool wet = stage.water && floor < 0.0F && !ground.is_dry(place.x, place.y);
  place.z = (wet ? 0.0F : floor) + static_cast<float>(params.height_m);
  if (params.target_x_m || params.target_y_m)
    target.z = ground_at(ground, target) + static_cast<float>(params.target_height_m);
  Camera camera = aim_camera(view, target, 1.0);
  camera.position = place;
  return turn_camera(camera, target);
}

/// How far one sees from a place in a direction before the ground rises into the view.
float free_way(const Ground& ground, Vec3 eye, float azimuth, float most) {
  const float step = std::max(2.0F * ground.cell_m(), 0.004F * most);
  for (float way = step; way < most; way += step) {
    const float x = eye.x + way * std::sin(azimuth), y = eye.y + way * std::cos(azimuth);
    if (std::abs(x) > ground.half_width_m() || std::abs(y) > ground.half_height_m()) return way;
    if (ground.form(x, y, step).height > eye.z) return way;
  }
  return most;
}

/// From within the deepest valley, along it, a quarter of its depth over its floor, times params.distance: where the
/// ground around stands highest over a place.
Camera canyon_camera(const CameraParams& params, const Stage& stage, const View& view, const Ground& ground) {
  const float size = 2.0F * std::min(ground.half_width_m(), ground.half_height_m()), around = 0.05F * size;
  Vec3 best{};
  float deepest = -1.0F;
  constexpr int kRaster = 96, kDirections = 12;
  for (int j = kRaster / 6; j < kRaster * 5 / 6; ++j) {
    for (int i = kRaster / 6; i < kRaster * 5 / 6; ++i) {
      Vec3 place{(2.0F * static_cast<float>(i) / kRaster - 1.0F) * ground.half_width_m(),
                 (2.0F * static_cast<float>(j) / kRaster - 1.0F) * ground.half_height_m(), 0.0F};
      place.z = ground.form(place.x, place.y, 0.4F * around).height;  // no gully
      if (stage.water && place.z < 0.0F && !ground.is_dry(place.x, place.y)) continue;
      // Walls to two sides, whichever they are: the second highest of three thirds of the directions.
      std::array<float, 3> walls = {-1e9F, -1e9F, -1e9F};
      for (int k = 0; k < kDirections; ++k) {
        const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(k) / kDirections;
        const float there =
            ground.form(place.x + around * std::sin(angle), place.y + around * std::cos(angle), 0.2F * around).height;
        float& wall = walls[static_cast<size_t>(k * 3 / kDirections)];
        wall = std::max(wall, there - place.z);
      }
      std::sort(walls.begin(), walls.end());
      if (walls[1] > deepest) {
        deepest = walls[1];
        best = place;
      }
    }
  }
  Vec3 eye = best;
  eye.z = std::max(eye.z, ground_at(ground, eye)) +
          std::max(2.0F, 0.25F * static_cast<float>(params.distance) * std::max(0.0F, deepest));
  float azimuth = 0.0F, farthest = -1.0F;
  constexpr int kViews = 48;
  for (int k = 0; k < kViews; ++k) {
    const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(k) / kViews;
    constexpr float kBeside = 0.25F;  // no wall before one's nose
    const float beside =
        4.0F * std::min(free_way(ground, eye, angle - kBeside, size), free_way(ground, eye, angle + kBeside, size));
    if (const float way = std::min(free_way(ground, eye, angle, size), beside); way > farthest) {
      farthest = way;
      azimuth = angle;
    }
  }
  if (params.azimuth_deg) azimuth = static_cast<float>(radians(*params.azimuth_deg)) + std::numbers::pi_v<float>;
  const Vec3 ahead{eye.x + 1000.0F * std::sin(azimuth), eye.y + 1000.0F * std::cos(azimuth),
                   eye.z - 1000.0F * static_cast<float>(std::tan(view.elevation)) + 60.0F};
  Camera camera = aim_camera(view, ahead, 1.0);
  camera.position = eye;
  return turn_camera(camera, ahead);
}

}  // namespace

void check_camera(const CameraParams& params) {
  if (params.x_m.has_value() != params.y_m.has_value())
    throw InvalidArgument(params.x_m ? "camera.y_m" : "camera.x_m", "is missing: a camera's place has both");
  if (params.x_m && params.distance_m)
    throw InvalidArgument("camera.distance_m", "contradicts camera.x_m and camera.y_m: give the place or the distance");
  const bool placed = params.distance_m || params.x_m || params.view == CameraView::canyon;
  const double elevation = params.elevation_deg.value_or(usual(params.view).elevation_deg);
  if (!placed && elevation < 1.0)
    throw InvalidArgument("camera.elevation_deg",
                          format_number(elevation) + " is outside [1, 89], unless camera.distance_m is given");
}

Camera place_camera(const CameraParams& params, const Stage& stage, const GridFrame& frame, const Ground& ground) {
  const Usual by_view = usual(params.view);
  View view;
  view.azimuth = radians(params.azimuth_deg.value_or(by_view.azimuth_deg));
  view.elevation = radians(params.elevation_deg.value_or(by_view.elevation_deg));
  view.field_of_view = radians(params.field_of_view_deg.value_or(by_view.field_of_view_deg));
  view.distance = params.distance;
  view.width_px = stage.width_px;
  view.height_px = stage.height_px;
  view.horizon = stage.sea;
  const bool around = params.view == CameraView::turntable;
  std::vector<Vec3> places =
      around ? all_places_to_show(ground, stage.sea, stage.base_m) : places_to_show(ground, stage.sea, stage.base_m);
  if (around) places = drum_around(places);
  Vec3 target = middle(places);
  const Vec3 fitted = target;
  const Vec3 given = place_at(params.target_x_m.value_or(0.0), params.target_y_m.value_or(0.0), frame);
  if (params.target_x_m) target.x = given.x;
  if (params.target_y_m) target.y = given.y;
  if (params.distance_m) return near_camera(params, stage, view, ground, target);
  if (params.x_m)
    return standing_camera(params, stage, view, ground, place_at(*params.x_m, *params.y_m, frame), target);
  if (params.view == CameraView::canyon) return canyon_camera(params, stage, view, ground);
  Camera camera = fit_camera(view, fitted, places);
  camera.position = camera.position + (target - fitted);
  // Never under ground or water.
  const float floor = std::max(ground.form(camera.position.x, camera.position.y, ground.cell_m()).height,
                               stage.sea && stage.water ? 0.0F : stage.base_m);
  camera.position.z = std::max(camera.position.z, floor + 2.0F * ground.cell_m());
  return camera;
}

SunDirection sun_direction(const SunParams& params, double latitude_deg) {
  const double noon = latitude_deg < 0.0 ? 0.0 : 180.0;
  const std::array<std::array<double, 2>, 4> usual_light = {{{285.0, 30.0}, {80.0, 14.0}, {noon, 65.0}, {275.0, 6.0}}};
  const auto& [azimuth, elevation] = usual_light[static_cast<size_t>(params.light)];
  return {radians(params.azimuth_deg.value_or(azimuth)), radians(params.elevation_deg.value_or(elevation))};
}

}  // namespace seamount::render
