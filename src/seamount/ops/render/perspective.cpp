#include "seamount/ops/render/perspective.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/rng.h"
#include "seamount/ops/render/place_camera.h"
#include "seamount/ops/render/scene.h"

namespace seamount::render {
namespace {

constexpr int kTile = 32;
constexpr int kFinePerSide = 3;  // rays of an uneven pixel, squared

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

Image perspective(const HeightField& terrain, const Shown& shown, const PerspectiveParams& params,
                  const RunContext& run) {
  check_params(params);
  const Climate climate = climate_of(params.climate, params.tree_line_m, params.snow_line_m, params.rock,
                                     setting_of(terrain, params.water_level_m, params.water));
  check_camera(params.camera);
  const SunDirection sun = sun_direction(params.sun, climate.latitude);
  const Ground ground(terrain, shown.labels,
                      {.water_level_m = params.water_level_m,
                       .exaggeration = params.vertical_exaggeration,
                       .sun = sun,
                       .style = params.style,
                       .layers = params.layers,
                       .lake = params.water ? shown.lake : nullptr,
                       .rivers = params.water ? shown.rivers : nullptr,
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
  const Camera camera = place_camera(
      params.camera, {params.width_px, params.height_px, sea, params.water, scene.base()}, terrain.frame(), ground);
  std::optional<ThingScene> standing;
  if (shown.things != nullptr && !shown.things->things.empty()) {
    standing.emplace(
        *shown.things, terrain, ground,
        ThingView{camera.position, camera.pixel_angle(), params.water_level_m, params.vertical_exaggeration}, quiet);
    scene.add_things(&*standing);
  }
  if (params.water && camera.position.z < 0.0F && params.camera.distance_m.has_value() &&
      !ground.is_dry(camera.position.x, camera.position.y))
    scene.submerge();

  Image image(params.width_px, params.height_px);
  const Painter painter(scene, camera, static_cast<float>(params.exposure) * sky.exposure(), image);
  const int columns = (params.width_px + kTile - 1) / kTile, rows = (params.height_px + kTile - 1) / kTile;
  parallel_blocks(run.part(0.3, 1.0), columns * rows, 1, [&](int64_t begin, int64_t end) {
    for (int64_t tile = begin; tile < end; ++tile) {
      painter.tile(static_cast<int>(tile % columns) * kTile, static_cast<int>(tile / columns) * kTile);
    }
  });
  return image;
}

}  // namespace seamount::render
