#include "seamount/ops/render/camera.h"

#include <algorithm>
#include <cmath>

namespace seamount::render {
namespace {

double mix_of(double a, double b, double t) { return a + t * (b - a); }

constexpr double kMargin = 0.96;     // part of the picture that the points may fill
constexpr double kSkyShare = 0.045;  // of the picture's height
constexpr double kMostBelow =
    0.30;                           // how far below the picture's middle that of the points may lie, of half its height
constexpr double kStepBack = 1.10;  // how much further one may go for the horizon's sake

/// Where points lie in the picture plane of a camera that looks level: the plane is one metre away.
struct Extent {
  bool in_front = true;
  double side = 0.0;                    ///< largest |x|
  double lowest = 1e9, highest = -1e9;  ///< angles of elevation
};

struct Rig {
  View view;
  Vec3 target;
  Vec3 toward;  ///< level direction from camera to target

  Vec3 position(double distance) const {
    const auto flat = static_cast<float>(distance * std::cos(view.elevation));
    Vec3 p = target - flat * toward;
    p.z += static_cast<float>(distance * std::sin(view.elevation));
    return p;
  }

  Extent extent(double distance, double pitch, const std::vector<Vec3>& points) const {
    const Vec3 from = position(distance);
    const Vec3 right{toward.y, -toward.x, 0.0F};
    Extent e;
    for (const Vec3& point : points) {
      const Vec3 d = point - from;
      const double ahead = dot(d, toward);
      const double depth = ahead * std::cos(pitch) - d.z * std::sin(pitch);
      if (ahead <= 0.0 || depth <= 0.0) return {.in_front = false};
      e.side = std::max(e.side, std::abs(static_cast<double>(dot(d, right))) / depth);
      const double angle = std::atan2(static_cast<double>(d.z), ahead);
      e.lowest = std::min(e.lowest, angle);
      e.highest = std::max(e.highest, angle);
    }
    return e;
  }
};

void look(Camera& camera, Vec3 toward, double pitch) {
  const auto c = static_cast<float>(std::cos(pitch)), s = static_cast<float>(std::sin(pitch));
  camera.forward = {c * toward.x, c * toward.y, -s};
  camera.up = {s * toward.x, s * toward.y, c};
  camera.right = {toward.y, -toward.x, 0.0F};
}

}  // namespace

Camera aim_camera(const View& view, Vec3 target, double distance) {
  const Rig rig{
      view, target, {static_cast<float>(-std::sin(view.azimuth)), static_cast<float>(-std::cos(view.azimuth)), 0.0F}};
  Camera camera;
  camera.position = rig.position(distance);
  look(camera, rig.toward, view.elevation);
  camera.tan_half_height = static_cast<float>(std::tan(0.5 * view.field_of_view));
  camera.width_px = static_cast<float>(view.width_px);
  camera.height_px = static_cast<float>(view.height_px);
  return camera;
}

Camera turn_camera(Camera camera, Vec3 target) {
  const Vec3 way = target - camera.position;
  const float flat = std::sqrt(way.x * way.x + way.y * way.y);
  if (flat <= 0.0F) return camera;
  look(camera, {way.x / flat, way.y / flat, 0.0F}, std::atan2(-static_cast<double>(way.z), static_cast<double>(flat)));
  return camera;
}

Camera fit_camera(const View& view, Vec3 target, const std::vector<Vec3>& points) {
  const double half_height = 0.5 * view.field_of_view;
  const double tan_height = std::tan(half_height);
  const double tan_width = tan_height * view.width_px / view.height_px;
  const Rig rig{
      view, target, {static_cast<float>(-std::sin(view.azimuth)), static_cast<float>(-std::cos(view.azimuth)), 0.0F}};
  double pitch = view.elevation;  // downwards
  const auto fits = [&](double distance) {
    Extent e = rig.extent(distance, pitch, points);
    if (!e.in_front) return false;
    pitch = -0.5 * (e.lowest + e.highest);
    e = rig.extent(distance, pitch, points);
    return e.in_front && e.side <= kMargin * tan_width && e.highest - e.lowest <= 2.0 * kMargin * half_height;
  };
  double far = 1.0;
  while (!fits(far) && far < 1e9) far *= 1.5;
  double near = far / 1.5;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (near + far);
    (fits(middle) ? far : near) = middle;
  }
  fits(far);
  double distance = far;
  if (view.horizon) {
    // Look up until the nearest points reach the lower margin, and step back a little if that shows some sky; if it
    // does not, leave somewhat more room above than below.
    const double wanted = std::atan(tan_height * (1.0 - 2.0 * kSkyShare));
    const auto lowest_pitch = [&](double d) { return -rig.extent(d, pitch, points).lowest - kMargin * half_height; };
    while (distance < kStepBack * far && lowest_pitch(distance) > wanted) distance *= 1.01;
    const bool sky = lowest_pitch(distance) <= wanted;
    if (!sky) distance = far;
    // What is looked at stays near the middle: an empty sea over it is worse than no sky.
    const Extent seen = rig.extent(distance, pitch, points);
    const double least = -0.5 * (seen.lowest + seen.highest) - kMostBelow * half_height;
    pitch = std::min(pitch, std::max(least, sky ? wanted : mix_of(pitch, lowest_pitch(distance), 0.3)));
  }
  if (view.distance < 1.0) {
    // Closer up the target itself moves to the middle.
    const double t = std::clamp((view.distance - 0.4) / 0.6, 0.0, 1.0);
    pitch = mix_of(view.elevation, pitch, t);
  }
  Camera camera;
  camera.position = rig.position(distance * view.distance);
  look(camera, rig.toward, pitch);
  camera.tan_half_height = static_cast<float>(tan_height);
  camera.width_px = static_cast<float>(view.width_px);
  camera.height_px = static_cast<float>(view.height_px);
  return camera;
}

}  // namespace seamount::render
