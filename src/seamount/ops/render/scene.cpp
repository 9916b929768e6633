#include "seamount/ops/render/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "seamount/ops/render/detail_noise.h"
#include "seamount/ops/render/water.h"

namespace seamount::render {
namespace {

constexpr float kFar = 1e9F;
constexpr float kHazeDepth = 0.022F;  // optical depth across the terrain
constexpr Rgb kTable{0.46F, 0.46F, 0.455F};

float lowest_of(const HeightField& heights) {
  return *std::min_element(heights.cells().begin(), heights.cells().end());
}

/// Mean depth of the water along the terrain's border; 0 where there is none.
float mean_border_depth(const HeightField& heights) {
  double sum = 0.0;
  int64_t count = 0;
  const auto add = [&](float h) {
    if (h >= 0.0F) return;
    sum -= h;
    ++count;
  };
  for (int x = 0; x < heights.width(); ++x) {
    add(heights(x, 0));
    add(heights(x, heights.height() - 1));
  }
  for (int y = 0; y < heights.height(); ++y) {
    add(heights(0, y));
    add(heights(heights.width() - 1, y));
  }
  return count > 0 ? static_cast<float>(sum / static_cast<double>(count)) : 0.0F;
}

}  // namespace

Scene::Scene(const Ground& ground, const Sky& sky, const SceneOptions& options, const RunContext& run)
    : ground_(ground), sky_(sky), options_(options), tracer_(ground.heights(), run) {
  const float size = 2.0F * std::max(ground.half_width_m(), ground.half_height_m());
  haze_.near_density = options.haze * kHazeDepth / size;
  haze_.far_length = 2.5F * size;
  base_ = lowest_of(ground.heights()) - 0.035F * size;
  border_depth_ = mean_border_depth(ground.heights());
}

float Scene::beyond(float x, float y) const {
  const float dx = std::max(0.0F, std::abs(x) - ground_.half_width_m());
  const float dy = std::max(0.0F, std::abs(y) - ground_.half_height_m());
  return std::sqrt(dx * dx + dy * dy);
}

LatticeRay Scene::lattice_ray(Vec3 from, Vec3 direction, float start) const {
  const float cell = ground_.cell_m();
  return {ground_.column(from.x + start * direction.x),
          ground_.row(from.y + start * direction.y),
          from.z + start * direction.z,
          direction.x / cell,
          -direction.y / cell,
          direction.z};
}

Hit Scene::hit(Vec3 from, Vec3 direction) const {
  Hit met = submerged_ ? submerged_hit(from, direction) : ground_hit(from, direction);
  if (things_ == nullptr) return met;
  if (const auto thing = things_->hit(from, direction, 0.0F, met.t > 0.0F ? met.t : kFar))
    met = {Surface::thing, thing->t, *thing};
  return met;
}

Hit Scene::ground_hit(Vec3 from, Vec3 direction) const {
  const bool dry = ground_.has_dry() && from.z <= 0.0F;  // the eye is in a dry place below the sea
  const Hit met = dry ? Hit{} : over_water_hit(from, direction);
  if (!ground_.has_dry() || (!dry && met.surface != Surface::sea)) return met;
  if (!dry) {
    const Vec3 place = from + met.t * direction;
    if (!ground_.is_dry(place.x, place.y)) return met;
  }
  float begin = met.t, end = kFar;
  if (!tracer_.clip(lattice_ray(from, direction, 0.0F), begin, end)) return met;
  const float inside = tracer_.trace(lattice_ray(from, direction, begin), 0.0F, end - begin);
  return inside >= 0.0F ? Hit{Surface::land, begin + inside} : met;
}

Hit Scene::over_water_hit(Vec3 from, Vec3 direction) const {
  float end = kFar;
  Surface last = Surface::sky;
  if (options_.sea && options_.water && direction.z < 0.0F) {
    end = from.z / -direction.z;
    last = Surface::sea;
  } else if (!options_.sea && direction.z < 0.0F) {
    end = (from.z - base_) / -direction.z;
    last = Surface::table;
  }
  float enter = 0.0F, leave = end;
  if (!tracer_.clip(lattice_ray(from, direction, 0.0F), enter, leave)) return {last, end};
  // From here on t counts from where the ray comes over the terrain: floats are finer there.
  const LatticeRay ray = lattice_ray(from, direction, enter);
  if (direction.z >= 0.0F && ray.height > tracer_.highest()) return {last, end};
  const float ground = tracer_.height(ray.column, ray.row);
  if (enter > 0.0F && ray.height < ground) return {Surface::wall, enter};
  float water = kFar;
  if (!options_.sea && options_.water) {
    if (enter > 0.0F && ray.height < 0.0F) return {Surface::water_wall, enter};
    if (direction.z < 0.0F) water = ray.height / -direction.z;
  }
  const float inside = tracer_.trace(ray, 0.0F, std::min(leave - enter, water));
  if (inside >= 0.0F) return {Surface::land, enter + inside};
  if (water <= leave - enter) return {Surface::sea, enter + water};
  return {last, end};
}

Rgb Scene::light(Vec3 from, Vec3 direction, Hit hit, float pixel_angle, Dice dice) const {
  if (submerged_) return submerged_light(from, direction, hit, pixel_angle, dice);
  if (hit.surface == Surface::sky) {
    return options_.sea || direction.z > 0.0F ? sky_.radiance(direction) : sky_.haze(direction);
  }
  const Rgb near = surface_light(from, direction, hit, pixel_angle, dice);
  const Rgb through = haze_.transmittance(hit.t);
  return through * near + (Rgb{1.0F, 1.0F, 1.0F} - through) * sky_.haze(direction);
}

Rgb Scene::surface_light(Vec3 from, Vec3 direction, Hit hit, float pixel_angle, Dice dice) const {
  const Vec3 place = from + hit.t * direction;
  const float width = hit.t * pixel_angle;
  const float grazing = std::max(0.08F, -direction.z);
  const float footprint = width / std::sqrt(grazing);  // between the pixel's width and its length on level ground
  switch (hit.surface) {
    case Surface::land:
      return land_light(place, direction, width * 1.15F, dice);
    case Surface::sea:
      return sea_light(place, direction, footprint, dice);
    case Surface::wall:
      return wall_light(place, width);
    case Surface::water_wall:
      return water_wall_light(place, direction, width);
    case Surface::table:
      return table_light(place);
    case Surface::thing:
      return thing_light(place, direction, hit.thing, width, dice);
    case Surface::sky:
    case Surface::underside:
    case Surface::deep:
      break;
  }
  return sky_.radiance(direction);
}

Rgb Scene::land_light(Vec3 place, Vec3 direction, float footprint, Dice dice) const {
  const GroundSample s = ground_.sample(place.x, place.y, footprint);
  SurfacePoint point = s.point;
  if (options_.water && point.lake > 0.0F) return lake_light(place, direction, footprint, s, dice);
  if (!options_.water) point.z = std::max(point.z, 5.0F);
  const Material material = ground_material(point, options_.rules);
  const Vec3 normal = ground_.normal(s, material.bump);
  const Lamp lamp = this->lamp(place);
  const Vec3 sun = lamp.to_sun;
  float facing = std::max(0.0F, dot(normal, sun)) * s.form.sun;
  // Open sky over the slope; what hides the rest sends some sunlight of its own colour.
  float open = s.cover.sky * (0.55F + 0.45F * normal.z);
  if (things_ != nullptr) {
    const Vec3 start = place + beside_surface(place) * normal;
    if (facing > 0.0F) facing *= sun_past_things(start, sun, dice);
    open *= sky_past_things(start, normal, dice);
  }
  if (submerged_) facing *= caustics(place, footprint);
  const Rgb sky = open * (0.85F + 0.15F * dot(normal, sun)) * lamp.sky;
  const float bounce = 0.35F * (1.0F - open) * (0.3F + 0.7F * sun.z);
  const Rgb light = facing * lamp.sun + sky + bounce * (material.albedo * lamp.sun);
  // Rough ground is a little brighter towards the sun's side (Oren and Nayar), which also fills grazing views.
  const float back = 1.0F + 0.12F * std::max(0.0F, -dot(direction, sun));
  const Rgb seen = back * (material.albedo * light) + material.glow;
  constexpr float kTrace = 0.01F;  // of water: not worth drawing
  if (!options_.water || point.river < kTrace || submerged_) return seen;
  return mix(seen, river_light(place, direction, footprint, s, dice), point.river);
}

Rgb Scene::river_light(Vec3 place, Vec3 direction, float footprint, const GroundSample& ground, Dice dice) const {
  WaterPoint water;
  water.to_eye = -1.0F * direction;
  water.x = place.x;
  water.y = place.y;
  water.footprint = footprint;
  water.depth = kRiverDepth_m;
  water.shelter = 1.0F;
  water.glint = 0.2F;
  water.sun = ground.form.sun;
  water.sky = ground.cover.sky;
  water.floor = river_bed();
  if (things_ != nullptr) water.sun *= sun_past_things(place, sky_.to_sun(), dice);
  return water_light(water, sky_, 0.3F * options_.clarity);
}

Vec3 Scene::refracted_floor(Vec3 place, Vec3 direction) const {
  constexpr float kDeepest = 90.0F;  // metres; nothing is seen from below
  const float down = refracted_cosine(std::max(0.01F, -direction.z));
  const float side = std::sqrt((1.0F - down * down) / std::max(1e-6F, 1.0F - direction.z * direction.z));
  const Vec3 refracted{side * direction.x, side * direction.y, -down};
  float begin = 0.0F, end = kDeepest / down;
  const LatticeRay ray = lattice_ray({place.x, place.y, 0.0F}, refracted, 0.0F);
  if (!tracer_.clip(ray, begin, end)) return place;
  const float t = tracer_.trace(ray, begin, end);
  return place + (t >= 0.0F ? t : end) * refracted;
}

float Scene::foam(Vec3 place, float footprint, float depth) const {
  if (depth > 8.0F) return 0.0F;
  // Swell breaks where the floor drops into open water within a few boat lengths; a lagoon has none.
  const float reach = std::max(25.0F, 1.5F * footprint);
  const FormTexel around = ground_.form(place.x, place.y, reach);
  const float slope = std::sqrt(around.east * around.east + around.south * around.south) + 1e-6F;
  const auto below = [&](float distance) {
    return ground_.sample(place.x - distance * around.east / slope, place.y + distance * around.south / slope, reach);
  };
  const GroundSample off = below(3.0F * reach);
  const float open = ramp(18.0F, 34.0F, -off.point.z) * (1.0F - clamp01(off.point.lagoon));
  const float drop = ramp(5.0F, 14.0F, -below(reach).point.z);
  return foam_share(place.x, place.y, footprint, depth, open * drop, open);
}

Rgb Scene::sea_light(Vec3 place, Vec3 direction, float footprint, Dice dice) const {
  const float out = beyond(place.x, place.y);
  WaterPoint water;
  water.to_eye = -1.0F * direction;
  water.x = place.x;
  water.y = place.y;
  water.footprint = footprint;
  const Vec3 floor = refracted_floor(place, direction);
  // Beyond the border the floor goes on, ever smoother, and comes to the mean depth of the border.
  const float size = 2.0F * std::max(ground_.half_width_m(), ground_.half_height_m());
  GroundSample s = ground_.sample(floor.x, floor.y, std::max(footprint, std::min(0.8F * out, 0.06F * size)));
  water.depth = std::max(0.0F, -s.point.z);
  if (out > 0.0F) {
    const float cliff = 80.0F * ramp(-3.0F, 0.5F, s.point.z);  // land that is cut off falls into deep water
    const float swell = detail_noise(141, floor.x, floor.y, 0.2F * size, 3, 0.5F, footprint).value;
    const float far = border_depth_ * (1.0F + 0.2F * swell);
    const float near = std::exp(-out / (0.06F * size));
    // A broad bank that is cut off by the border fades out (by the ratio of depths); a coast's shallows fall away.
    const float broad = -ground_.form(floor.x, floor.y, 0.04F * size).height / ground_.exaggeration();
    const float bank = ramp(2.0F, 5.0F, broad) * ramp(90.0F, 30.0F, broad);
    constexpr float kLeast = 0.5F;
    const float cut = water.depth + cliff;
    water.depth = mix(mix(far, cut, near),
                      std::exp(mix(std::log(std::max(far, kLeast)), std::log(std::max(cut, kLeast)), near)), bank);
    s.point.reef *= near;
    s.point.shore_m += out;
  }
  water.shelter = clamp01(s.point.lagoon + 3.0F * s.point.concavity) * ramp(60.0F, 20.0F, water.depth);
  s.point.z = -water.depth;
  const float fade = std::exp(-out / (0.008F * ground_.half_width_m()));
  water.sun = mix(1.0F, s.form.sun, fade);
  water.sky = mix(1.0F, s.cover.sky, fade);
  constexpr float kUnseen = 120.0F;  // metres: of what is deeper nothing comes up
  if (water.depth < kUnseen * options_.clarity || things_ != nullptr)
    water.floor = floor_material(s.point, options_.rules).albedo;
  if (out <= 0.0F) water.foam = foam(place, footprint, water.depth);
  if (things_ != nullptr && out <= 0.0F) {
    see_things_below(place, floor, water.depth, water.floor, dice);
    water.sun *= sun_past_things(place, sky_.to_sun(), dice);
  }
  return water_light(water, sky_, options_.clarity);
}

Rgb Scene::lake_light(Vec3 place, Vec3 direction, float footprint, const GroundSample& ground, Dice dice) const {
  WaterPoint water;
  water.to_eye = -1.0F * direction;
  water.x = place.x;
  water.y = place.y;
  water.footprint = footprint;
  water.depth = ground.point.lake;
  water.shelter = 0.7F;
  water.sun = ground.form.sun;
  water.sky = ground.cover.sky;
  SurfacePoint bed = ground.point;
  bed.z = -water.depth;
  water.floor = floor_material(bed, options_.rules).albedo;
  if (things_ != nullptr) water.sun *= sun_past_things(place, sky_.to_sun(), dice);
  return water_light(water, sky_, options_.clarity);
}

Vec3 Scene::wall_normal(Vec3 place) const {
  const float dx = ground_.half_width_m() - std::abs(place.x), dy = ground_.half_height_m() - std::abs(place.y);
  if (dx < dy) return {place.x > 0.0F ? 1.0F : -1.0F, 0.0F, 0.0F};
  return {0.0F, place.y > 0.0F ? 1.0F : -1.0F, 0.0F};
}

Rgb Scene::wall_light(Vec3 place, float footprint) const {
  constexpr Rgb kTopSoil{0.075F, 0.056F, 0.040F}, kEarth{0.160F, 0.120F, 0.085F}, kBedrock{0.112F, 0.098F, 0.085F};
  const float size = 2.0F * std::max(ground_.half_width_m(), ground_.half_height_m());
  const float top = ground_.form(place.x, place.y, footprint).height;
  const float below = std::max(0.0F, top - place.z);
  const float along = place.x + place.y;
  const float wander = detail_noise(151, along, 0.35F * place.z, 0.09F * size, 4, 0.5F, footprint).value;
  // Beds dip gently; their thickness follows the size of the block.
  const float bed = detail_noise(157, 0.02F * along, place.z + 0.10F * below + 0.012F * size * wander, 0.016F * size, 4,
                                 0.7F, 0.4F * footprint)
                        .value;
  Rgb albedo = mix(kEarth, kBedrock, clamp01(below / (0.09F * size) + 0.5F * wander));
  albedo = (1.0F + 0.55F * bed) * albedo;
  albedo = mix(kTopSoil, albedo, ramp(0.0015F * size, 0.0045F * size, below + 0.002F * size * wander));
  const Vec3 normal = wall_normal(place);
  const float facing = std::max(0.0F, dot(normal, sky_.to_sun()));
  const float contact = options_.sea ? 1.0F : 0.55F + 0.45F * ramp(0.0F, 0.03F * size, place.z - base_);
  const Rgb bounced = (0.16F * std::max(0.0F, sky_.to_sun().z)) * sky_.sun_light();  // from the table or the sea
  return contact * (albedo * (0.8F * facing * sky_.sun_light() + 0.55F * sky_.sky_light() + bounced));
}

Rgb Scene::water_wall_light(Vec3 place, Vec3 direction, float footprint) const {
  // Through the cut face of the water to the floor, or out at another side.
  const LatticeRay ray = lattice_ray(place, direction, 0.0F);
  float begin = 0.0F, end = kFar;
  if (!tracer_.clip(ray, begin, end)) end = 0.0F;
  const float inside = end > begin ? tracer_.trace(ray, begin, end) : -1.0F;
  const float path = std::max(0.0F, inside >= 0.0F ? inside : end);
  const Vec3 floor = place + path * direction;
  const GroundSample s = ground_.sample(floor.x, floor.y, footprint);
  // A block of water is drawn clearer than the sea, so that the floor shows through its side.
  const float size = 2.0F * std::max(ground_.half_width_m(), ground_.half_height_m());
  const Rgb through = water_transmittance(path, options_.clarity * (1.0F + size / 1500.0F));
  const float depth = clamp01(-place.z / (0.10F * size));
  const Rgb body = mix(Rgb{0.030F, 0.125F, 0.190F}, Rgb{0.006F, 0.028F, 0.075F}, depth);
  const Rgb down = 0.5F * sky_.sun_light() + sky_.sky_light();
  const float facing = 0.75F + 0.25F * std::max(0.0F, dot(wall_normal(place), sky_.to_sun()));
  return facing * down * (body + through * (0.6F * floor_material(s.point, options_.rules).albedo - body));
}

float Scene::table_sun(Vec3 place) const {
  constexpr std::array<std::array<float, 2>, 8> kDisc = {{{-0.9F, 0.3F},
                                                          {0.2F, 0.9F},
                                                          {0.9F, -0.2F},
                                                          {-0.3F, -0.8F},
                                                          {0.5F, 0.4F},
                                                          {-0.4F, 0.1F},
                                                          {0.3F, -0.4F},
                                                          {-0.6F, -0.4F}}};
  constexpr float kSunHalfWidth = 0.035F;
  const Vec3 sun = sky_.to_sun();
  const Vec3 side = normalised({sun.y, -sun.x, 1e-6F});
  float lit = 0.0F;
  for (const auto& [across, up] : kDisc) {
    const Vec3 toward = normalised(sun + (kSunHalfWidth * across) * side + Vec3{0.0F, 0.0F, kSunHalfWidth * up});
    float begin = 0.0F, end = kFar;
    if (tracer_.clip(lattice_ray(place, toward, 0.0F), begin, end)) {
      const LatticeRay ray = lattice_ray(place, toward, begin);
      if (ray.height < tracer_.height(ray.column, ray.row) || tracer_.trace(ray, 0.0F, end - begin) >= 0.0F) continue;
    }
    lit += 1.0F / static_cast<float>(kDisc.size());
  }
  return lit;
}

Rgb Scene::table_light(Vec3 place) const {
  const float size = 2.0F * std::max(ground_.half_width_m(), ground_.half_height_m());
  const float out = beyond(place.x, place.y);
  const float contact = 1.0F - 0.50F * std::exp(-out / (0.030F * size)) - 0.12F * std::exp(-out / (0.2F * size));
  const Vec3 sun = sky_.to_sun();
  const float longest = (tracer_.highest() - base_) * std::sqrt(1.0F - sun.z * sun.z) / std::max(0.02F, sun.z);
  const float lit = out < longest ? table_sun(place) : 1.0F;
  return contact * (kTable * ((lit * 0.7F * sun.z) * sky_.sun_light() + sky_.sky_light()));
}

}  // namespace seamount::render
