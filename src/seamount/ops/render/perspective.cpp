#include "seamount/ops/render/perspective.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/rng.h"
#include "seamount/ops/render/camera.h"
#include "seamount/ops/render/scene.h"
#include "seamount/ops/render/subject.h"

namespace seamount::render {
namespace {

constexpr int kTile = 32;
constexpr int kFinePerSide = 3;  // rays of an uneven pixel, squared

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// The middle of the places' extent, at a height of the lower part of the terrain.
Vec3 middle(const std::vector<Vec3>& places) {
  Vec3 low = places.front(), high = low;
  for (const Vec3& p : places) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return {0.5F * (low.x + high.x), 0.5F * (low.y + high.y), low.z + 0.3F * (high.z - low.z)};
}

/// A camera so many metres from a place on the ground, that it looks at. Over ground, in water or over it.
Camera near_camera(const PerspectiveParams& params, const View& view, const Ground& ground, Vec3 target, bool sea,
                   float base) {
  const float fine = 1e-3F * ground.cell_m();
  target.z = ground.form(target.x, target.y, fine).height + static_cast<float>(params.camera.target_height_m);
  Camera camera = aim_camera(view, target, *params.camera.distance_m);
  const float floor = std::max(ground.form(camera.position.x, camera.position.y, fine).height, sea ? -1e9F : base);
  const auto clear = static_cast<float>(std::clamp(0.04 * *params.camera.distance_m, 0.05, 2.0));
  if (camera.position.z < floor + clear) {
    camera.position.z = floor + clear;
    camera = turn_camera(camera, target);
  }
  constexpr float kOfSurface = 0.02F;  // neither in nor out of the water is no place for an eye
  if (params.water && std::abs(camera.position.z) < kOfSurface && !ground.is_dry(camera.position.x, camera.position.y))
    camera.position.z = camera.position.z < 0.0F ? -kOfSurface : kOfSurface;
  return camera;
}

Camera place_camera(const PerspectiveParams& params, const GridFrame& frame, const Ground& ground, bool sea,
                    float base) {
  View view;
  view.azimuth = radians(params.camera.azimuth_deg);
  view.elevation = radians(params.camera.elevation_deg);
  view.field_of_view = radians(params.camera.field_of_view_deg);
  view.distance = params.camera.distance;
  view.width_px = params.width_px;
  view.height_px = params.height_px;
  view.horizon = sea;
  const std::vector<Vec3> places = places_to_show(ground, sea, base);
  Vec3 target = middle(places);
  const Vec3 fitted = target;
  if (params.camera.target_x_m)
    target.x = static_cast<float>(*params.camera.target_x_m - (frame.west_m + 0.5 * frame.width_m()));
  if (params.camera.target_y_m)
    target.y = static_cast<float>(*params.camera.target_y_m - (frame.north_m - 0.5 * frame.height_m()));
  if (params.camera.distance_m) return near_camera(params, view, ground, target, sea, base);
  Camera camera = fit_camera(view, fitted, places);
  camera.position = camera.position + (target - fitted);
  // Never under ground or water.
  const float floor = std::max(ground.form(camera.position.x, camera.position.y, ground.cell_m()).height,
                               sea && params.water ? 0.0F : base);
  camera.position.z = std::max(camera.position.z, floor + 2.0F * ground.cell_m());
  return camera;
}

/// Draws tiles of the picture.
class Painter {
 public:
  Painter(const Scene& scene, const Camera& camera, float exposure, Image& image)
      : scene_(scene), camera_(camera), exposure_(exposure), image_(image) {}

  void tile(int x0, int y0) const {
    const int x1 = std::min(x0 + kTile, image_.width), y1 = std::min(y0 + kTile, image_.height);
    if (scene_.things() != nullptr) return tile_of_things(x0, y0, x1, y1);
    std::vector<Hit> corners(static_cast<size_t>((kTile + 1) * (kTile + 1)));
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        corners[corner(x - x0, y - y0)] =
            scene_.hit(camera_.position, camera_.direction(static_cast<float>(x), static_cast<float>(y)));
      }
    }
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        const std::array<Hit, 4> seen = {corners[corner(x - x0, y - y0)], corners[corner(x - x0 + 1, y - y0)],
                                         corners[corner(x - x0, y - y0 + 1)], corners[corner(x - x0 + 1, y - y0 + 1)]};
        write_dithered(image_.pixel(x, y), x, y, even(seen) ? whole(x, y, seen) : fine(x, y));
      }
    }
  }

 private:
  static size_t corner(int x, int y) { return static_cast<size_t>(y * (kTile + 1) + x); }

  /// What a pixel's corner sees, as far as it tells whether one look is enough.
  struct Glance {
    Hit hit;
    bool busy = false;    ///< things are near
    bool shaded = false;  ///< by a thing
  };

  Glance glance(float x, float y) const {
    const ThingScene& things = *scene_.things();
    const Vec3 direction = camera_.direction(x, y);
    Glance seen{scene_.hit(camera_.position, direction)};
    constexpr float kSee = 3e4F;  // metres
    const float depth = seen.hit.t > 0.0F ? std::min(seen.hit.t, kSee) : kSee;
    // Under water things show through the surface, a little aside of the straight way.
    const bool water = seen.hit.surface == Surface::sea;
    const float far = water ? seen.hit.t + 60.0F : seen.hit.surface == Surface::sky ? kSee : 1.05F * seen.hit.t;
    seen.busy = seen.hit.surface == Surface::thing ||
                things.near(camera_.position, direction, far,
                            0.15F * things.reach() + depth * camera_.pixel_angle() + (water ? 4.0F : 0.0F));
    if (!seen.busy && (seen.hit.surface == Surface::land || water))
      seen.shaded = scene_.shaded(camera_.position + seen.hit.t * direction);
    return seen;
  }

  void tile_of_things(int x0, int y0, int x1, int y1) const {
    std::vector<Glance> corners(static_cast<size_t>((kTile + 1) * (kTile + 1)));
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x)
        corners[corner(x - x0, y - y0)] = glance(static_cast<float>(x), static_cast<float>(y));
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        const std::array<const Glance*, 4> seen = {
            &corners[corner(x - x0, y - y0)], &corners[corner(x - x0 + 1, y - y0)],
            &corners[corner(x - x0, y - y0 + 1)], &corners[corner(x - x0 + 1, y - y0 + 1)]};
        std::array<Hit, 4> hits;
        bool busy = false, mixed = false;
        for (size_t k = 0; k < 4; ++k) {
          hits[k] = seen[k]->hit;
          busy = busy || seen[k]->busy;
          mixed = mixed || seen[k]->shaded != seen[0]->shaded;
        }
        const bool one_look = !busy && !mixed && even(hits);
        write_dithered(image_.pixel(x, y), x, y, one_look ? whole(x, y, hits) : close(x, y));
      }
    }
  }

  /// Rays of a pixel in strata, each with its own dice, stratified too and turned from pixel to pixel.
  Rgb close(int x, int y) const {
    Rgb sum;
    const uint64_t key = mix_bits(static_cast<uint64_t>(y) << 32 | static_cast<uint64_t>(x));
    const float turn_u = static_cast<float>(key & 0xffffU) / 65536.0F,
                turn_v = static_cast<float>(key >> 48) / 65536.0F;
    const auto turned = [](float a, float b) { return a + b >= 1.0F ? a + b - 1.0F : a + b; };
    // The corners of a square of three by three first: where they agree, the others are not needed.
    constexpr std::array<std::array<float, 2>, 9> kStrata = {
        {{0, 0}, {2, 2}, {2, 0}, {0, 2}, {1, 1}, {1, 0}, {1, 2}, {0, 1}, {2, 1}}};
    constexpr size_t kFirst = 4;
    constexpr float kStep = 1.0F / 3.0F, kAgree = 0.035F;
    Rgb low{9.0F, 9.0F, 9.0F}, high;
    for (size_t k = 0; k < kStrata.size(); ++k) {
      const float u = (kStrata[k][0] + 0.5F) * kStep, v = (kStrata[k][1] + 0.5F) * kStep;
      const Vec3 direction = camera_.direction(static_cast<float>(x) + u, static_cast<float>(y) + v);
      const Hit hit = scene_.hit(camera_.position, direction);
      const Dice dice{turned(v, turn_v), turned(u, turn_u), turned(u, turn_v), turned(v, turn_u)};
      const Rgb seen =
          tone_curve(exposure_ * scene_.light(camera_.position, direction, hit, camera_.pixel_angle(), dice));
      sum += seen;
      low = {std::min(low.r, seen.r), std::min(low.g, seen.g), std::min(low.b, seen.b)};
      high = {std::max(high.r, seen.r), std::max(high.g, seen.g), std::max(high.b, seen.b)};
      const Rgb range = high - low;
      if (k + 1 == kFirst && std::max({range.r, range.g, range.b}) < kAgree) return (1.0F / kFirst) * sum;
    }
    return (1.0F / static_cast<float>(kStrata.size())) * sum;
  }

  /// Whether the corners see one surface without a step in depth.
  bool even(const std::array<Hit, 4>& seen) const {
    float low = seen[0].t, high = low;
    for (const Hit& hit : seen) {
      if (hit.surface != seen[0].surface) return false;
      low = std::min(low, hit.t);
      high = std::max(high, hit.t);
    }
    if (seen[0].surface == Surface::sky) return true;
    if (seen[0].surface == Surface::wall || seen[0].surface == Surface::water_wall) return false;  // may hold a corner
    if (seen[0].surface == Surface::sea || seen[0].surface == Surface::table) return true;
    if (seen[0].surface == Surface::deep || seen[0].surface == Surface::underside) return true;
    return high - low < 7.0F * low * camera_.pixel_angle();
  }

  Rgb whole(int x, int y, const std::array<Hit, 4>& seen) const {
    const Vec3 direction = camera_.direction(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
    Hit hit = seen[0];
    hit.t = 0.25F * (seen[0].t + seen[1].t + seen[2].t + seen[3].t);
    if (hit.surface == Surface::sea || hit.surface == Surface::table || hit.surface == Surface::underside)
      hit = scene_.hit(camera_.position, direction);
    return tone_curve(exposure_ * scene_.light(camera_.position, direction, hit, camera_.pixel_angle()));
  }

  Rgb fine(int x, int y) const {
    Rgb sum;
    for (int j = 0; j < kFinePerSide; ++j) {
      for (int i = 0; i < kFinePerSide; ++i) {
        const Vec3 direction = camera_.direction(static_cast<float>(x) + (static_cast<float>(i) + 0.5F) / kFinePerSide,
                                                 static_cast<float>(y) + (static_cast<float>(j) + 0.5F) / kFinePerSide);
        const Hit hit = scene_.hit(camera_.position, direction);
        sum += tone_curve(exposure_ * scene_.light(camera_.position, direction, hit, camera_.pixel_angle()));
      }
    }
    return (1.0F / (kFinePerSide * kFinePerSide)) * sum;
  }

  const Scene& scene_;
  const Camera& camera_;
  float exposure_;
  Image& image_;
};

}  // namespace

Image perspective(const HeightField& terrain, const LabelMap* labels, const PerspectiveParams& params,
                  const RunContext& run) {
  return perspective(terrain, labels, nullptr, params, run);
}

Image perspective(const HeightField& terrain, const LabelMap* labels, const Things* things,
                  const PerspectiveParams& params, const RunContext& run) {
  return perspective(terrain, labels, things, nullptr, params, run);
}

Image perspective(const HeightField& terrain, const LabelMap* labels, const Things* things, const ScalarField* lake,
                  const PerspectiveParams& params, const RunContext& run) {
  check_params(params);
  if (!params.camera.distance_m && params.camera.elevation_deg < 1.0)
    throw InvalidArgument("camera.elevation_deg", format_number(params.camera.elevation_deg) +
                                                      " is outside [1, 89], unless camera.distance_m is given");
  const SunDirection sun{radians(params.sun.azimuth_deg), radians(params.sun.elevation_deg)};
  const Climate climate = climate_of(params.climate, params.tree_line_m, params.snow_line_m, params.rock,
                                     setting_of(terrain, params.water_level_m, params.water));
  const Ground ground(terrain, labels,
                      {.water_level_m = params.water_level_m,
                       .exaggeration = params.vertical_exaggeration,
                       .sun = sun,
                       .style = params.style,
                       .layers = params.layers,
                       .lake = params.water ? lake : nullptr,
                       .min_sea_m2 = params.min_sea_m2,
                       .wind_from = climate.wind_from},
                      run.part(0.0, 0.3));
  const bool sea = params.surround == Surround::sea ||
                   (params.surround == Surround::automatic && params.water && lies_in_sea(ground.heights(), 0.0));
  const Sky sky(sun);
  SceneOptions options;
  options.water = params.water;
  options.sea = sea;
  options.clarity = static_cast<float>(params.water_clarity);
  options.haze = static_cast<float>(params.haze);
  options.rules = {climate, params.style};
  const RunContext quiet{run.threads, {}, run.cancelled};
  Scene scene(ground, sky, options, quiet);
  const Camera camera = place_camera(params, terrain.frame(), ground, sea, scene.base());
  std::optional<ThingScene> standing;
  if (things != nullptr && !things->things.empty()) {
    standing.emplace(
        *things, terrain, ground,
        ThingView{camera.position, camera.pixel_angle(), params.water_level_m, params.vertical_exaggeration}, quiet);
    scene.add_things(&*standing);
  }
  if (params.water && camera.position.z < 0.0F && params.camera.distance_m &&
      !ground.is_dry(camera.position.x, camera.position.y))
    scene.submerge();

  Image image(params.width_px, params.height_px);
  const Painter painter(scene, camera, static_cast<float>(params.exposure), image);
  const int columns = (params.width_px + kTile - 1) / kTile, rows = (params.height_px + kTile - 1) / kTile;
  parallel_blocks(run.part(0.3, 1.0), columns * rows, 1, [&](int64_t begin, int64_t end) {
    for (int64_t tile = begin; tile < end; ++tile) {
      painter.tile(static_cast<int>(tile % columns) * kTile, static_cast<int>(tile / columns) * kTile);
    }
  });
  return image;
}

}  // namespace seamount::render
