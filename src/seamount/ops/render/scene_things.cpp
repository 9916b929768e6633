// Light on things, and what things keep from the ground and from one another.
#include <algorithm>
#include <cmath>

#include "seamount/ops/render/scene.h"
#include "seamount/ops/render/water.h"

namespace seamount::render {
namespace {

constexpr float kFar = 1e9F;
constexpr float kSunRadius = 0.008F;  // of its disc, radians; a little more than the real one's
constexpr float kTwoPi = 6.2831853F;

/// Two directions square to a unit vector and to each other.
void frame_around(Vec3 n, Vec3& u, Vec3& v) {
  u = std::abs(n.z) < 0.9F ? normalised({-n.y, n.x, 0.0F}) : normalised({0.0F, -n.z, n.y});
  v = {n.y * u.z - n.z * u.y, n.z * u.x - n.x * u.z, n.x * u.y - n.y * u.x};
}

}  // namespace

float Scene::beside_surface(Vec3 place) const {
  return 0.002F * std::min(1.0F, things_->reach()) +
         4e-7F * (std::abs(place.x) + std::abs(place.y) + std::abs(place.z));
}

bool Scene::shaded(Vec3 place) const {
  const Vec3 to_sun = lamp(place).to_sun;
  return things_->blocked(place + beside_surface(place) * Vec3{0.0F, 0.0F, 1.0F}, to_sun, 0.0F, kFar);
}

float Scene::sun_past_things(Vec3 place, Vec3 to_sun, Dice dice) const {
  Vec3 u, v;
  frame_around(to_sun, u, v);
  const float r = kSunRadius * std::sqrt(dice.sun_u), angle = kTwoPi * dice.sun_v;
  const Vec3 way = normalised(to_sun + (r * std::cos(angle)) * u + (r * std::sin(angle)) * v);
  return things_->blocked(place, way, 0.0F, kFar) ? 0.0F : 1.0F;
}

float Scene::sky_past_things(Vec3 place, Vec3 normal, Dice dice) const {
  // One direction by the cosine law; what is near hides more than what is far, and is not black itself.
  Vec3 u, v;
  frame_around(normal, u, v);
  const float r = std::sqrt(dice.sky_u), angle = kTwoPi * dice.sky_v;
  Vec3 way = (r * std::cos(angle)) * u + (r * std::sin(angle)) * v + std::sqrt(1.0F - dice.sky_u) * normal;
  if (way.z < 0.0F) way.z = -way.z;  // the ground's share is known without a ray
  const float reach = 1.3F * things_->reach();
  const auto hit = things_->hit(place, way, 0.0F, reach);
  return hit ? 0.10F + 0.90F * hit->t / reach : 1.0F;
}

float Scene::sun_past_ground(Vec3 place, Vec3 to_sun) const {
  const LatticeRay ray = lattice_ray(place, to_sun, 0.0F);
  float begin = 0.0F, end = kFar;
  if (!tracer_.clip(ray, begin, end)) return 1.0F;
  begin = std::max(begin, 0.5F * ground_.cell_m());  // the cell it stands on is as it is drawn, not as it was
  return begin < end && tracer_.trace(ray, begin, end) >= 0.0F ? 0.0F : 1.0F;
}

float Scene::sun_on_thing(const ThingSurface& s, Vec3 place, Vec3 to_sun, Dice dice) const {
  const float facing = dot(s.normal, to_sun), side = dot(s.outside, to_sun);
  const float beside = beside_surface(place);
  if (!s.leaf) {
    if (facing <= 0.0F) return 0.0F;
    return facing * sun_past_things(place + beside * s.outside + s.lift, to_sun, dice);
  }
  // Light falls on a leaf, or shines through it; a crown is bright on the sun's side as a whole.
  const float lit = side > 0.0F ? 0.62F * std::max(0.0F, facing) + 0.38F * side : 0.5F * -side;
  return lit * sun_past_things(place + (side > 0.0F ? beside : -beside) * s.outside, to_sun, dice);
}

Rgb Scene::thing_light(Vec3 place, Vec3 direction, const ThingHit& hit, float footprint, Dice dice) const {
  const ThingSurface s = things_->surface(hit, direction);
  const Lamp lamp = this->lamp(place);
  const Vec3 start = place + beside_surface(place) * s.outside + s.lift;
  const float side = dot(s.outside, lamp.to_sun);
  float lit = sun_on_thing(s, place, lamp.to_sun, dice);
  if (lit > 0.0F) lit *= sun_past_ground(start, lamp.to_sun);
  if (submerged_ && lit > 0.0F) lit *= caustics(place, footprint);
  const float open = (0.55F + 0.45F * s.normal.z) * sky_past_things(start, s.normal, dice);
  const Rgb through = s.leaf && side < 0.0F ? Rgb{1.10F, 1.12F, 0.60F} : Rgb{1.0F, 1.0F, 1.0F};
  const float below = 0.16F * (0.5F - 0.5F * s.normal.z) * std::max(0.0F, lamp.to_sun.z);
  const Rgb light = lit * (through * lamp.sun) + open * lamp.sky + below * lamp.sun;
  return s.albedo * light;
}

void Scene::see_things_below(Vec3 surface, Vec3 floor, float& depth, Rgb& albedo, Dice dice) const {
  const Vec3 way = floor - surface;
  const float length = std::sqrt(dot(way, way));
  const Vec3 sun = sky_.to_sun();
  const float down = refracted_cosine(std::max(0.02F, sun.z));
  const float side = 1.0F / 1.333F;
  const Vec3 to_sun = normalised({side * sun.x, side * sun.y, down});
  if (length > 1e-3F) {
    const Vec3 direction = (1.0F / length) * way;
    if (const auto met = things_->hit(surface, direction, 0.0F, length)) {
      const ThingSurface s = things_->surface(*met, direction);
      const Vec3 place = surface + met->t * direction, start = place + beside_surface(place) * s.outside;
      const float facing = sun_on_thing(s, place, to_sun, dice);
      const float sky = (0.5F + 0.5F * s.normal.z) * sky_past_things(start, s.normal, dice);
      depth = std::max(0.0F, -place.z);
      albedo = (0.80F * facing / down + 0.35F * sky) * s.albedo;
      return;
    }
  }
  const Vec3 start = floor + beside_surface(floor) * Vec3{0.0F, 0.0F, 1.0F};
  const float lit = sun_past_things(start, to_sun, dice), open = sky_past_things(start, {0.0F, 0.0F, 1.0F}, dice);
  albedo = (0.68F * lit + 0.32F * open) * albedo;
}

}  // namespace seamount::render
