// Seen from under water: what the floor and things send is lost on the way, blue last, and the water between sends
// light of its own (single scattering of the light that comes down, which falls off with depth as the light does).
// Above, the sky stands in Snell's window; beyond it the surface mirrors what is below.
#include <algorithm>
#include <cmath>

#include "seamount/ops/render/detail_noise.h"
#include "seamount/ops/render/scene.h"
#include "seamount/ops/render/water.h"

namespace seamount::render {
namespace {

constexpr float kFar = 1e9F;
constexpr float kIndex = 1.333F;
constexpr Rgb kAbsorption{0.225F, 0.055F, 0.026F};  // per metre, clear ocean water between Jerlov's types I and IB
constexpr Rgb kScattering{0.030F, 0.040F, 0.052F};  // per metre, out of a ray
constexpr float kPhase = 0.26F;                     // of it, towards the eye, of the light from above

float fresnel(float cosine) {
  const float c = 1.0F - cosine;
  return 0.02F + 0.98F * c * c * c * c * c;
}

Rgb power_of(Rgb per_metre, float metres) { return exp_of((-metres) * per_metre); }

}  // namespace

Hit Scene::submerged_hit(Vec3 from, Vec3 direction) const {
  float end = kFar;
  Surface last = Surface::deep;
  if (direction.z > 1e-6F) {
    end = -from.z / direction.z;
    last = Surface::underside;
  }
  float enter = 0.0F, leave = end;
  const LatticeRay ray = lattice_ray(from, direction, 0.0F);
  if (!tracer_.clip(ray, enter, leave)) return {last, end};
  const float inside = tracer_.trace(ray, enter, leave);
  return inside >= 0.0F ? Hit{Surface::land, inside} : Hit{last, end};
}

Lamp Scene::lamp(Vec3 place) const {
  if (!submerged_ || place.z >= 0.0F) return {sky_.to_sun(), sky_.sun_light(), sky_.sky_light()};
  const Vec3 sun = sky_.to_sun();
  const float height = std::max(0.02F, sun.z), down = refracted_cosine(height);
  const Vec3 to_sun = normalised({sun.x / kIndex, sun.y / kIndex, down});
  const float depth = -place.z;
  const float enters = (1.0F - fresnel(height)) * height / down;  // as much light on level ground as comes in
  const Rgb beam = enters * (water_transmittance(depth / down, options_.clarity) * sky_.sun_light());
  // The sky through the surface, and what the water around scatters from all sides.
  const Rgb sky = water_transmittance(1.2F * depth, options_.clarity) *
                  (0.93F * sky_.sky_light() + (0.22F * ramp(0.0F, 6.0F, depth)) * enters * sky_.sun_light());
  return {to_sun, beam, sky};
}

float Scene::caustics(Vec3 place, float footprint) const {
  const float depth = -place.z;
  if (depth <= 0.0F) return 1.0F;
  const float strength = ramp(0.05F, 0.6F, depth) * ramp(22.0F, 3.0F, depth) * ramp(0.30F, 0.05F, footprint);
  if (strength <= 0.0F) return 1.0F;
  // Folds of light: thin bright lines where two fields of waves are in step.
  const Vec3 to_sun = lamp(place).to_sun;
  const float x = place.x + to_sun.x / to_sun.z * depth, y = place.y + to_sun.y / to_sun.z * depth;
  const float wide = 0.55F + 0.06F * depth;
  const float bend = gradient_noise(211, x / (2.3F * wide), y / (2.3F * wide)).value;
  const float a = gradient_noise(223, (x + 0.5F * bend) / wide, (y - 0.4F * bend) / wide).value;
  const float b =
      gradient_noise(227, (0.8F * x + 0.6F * y) / (0.7F * wide), (0.8F * y - 0.6F * x) / (0.7F * wide)).value;
  const float line = 1.0F - std::min(1.0F, 2.6F * std::abs(a + 0.45F * b));
  return mix(1.0F, 0.62F + 1.75F * line * line * line, strength);
}

Rgb Scene::water_glow(Vec3 from, Vec3 direction, float length) const {
  const Rgb absorbed = (1.0F / options_.clarity) * kAbsorption;
  const Rgb scattered = (1.0F / options_.clarity) * kScattering;
  const Rgb lost = absorbed + scattered;
  const Vec3 sun = sky_.to_sun();
  const float height = std::max(0.02F, sun.z);
  const Rgb above = ((1.0F - fresnel(height)) * height) * sky_.sun_light() + sky_.sky_light();
  const Rgb here = power_of(absorbed, 1.15F * std::max(0.0F, -from.z)) * above;
  // Light falls off with depth: the ray gains exp(absorbed rise s) of it on its way.
  const auto along = [&](float l, float a) {
    const float rate = std::max(1e-5F, l - 1.15F * a * direction.z);
    return (1.0F - std::exp(-rate * std::min(length, 1e5F))) / rate;
  };
  const Rgb sum{along(lost.r, absorbed.r), along(lost.g, absorbed.g), along(lost.b, absorbed.b)};
  // More is scattered forwards: it is brighter towards the sun.
  const Vec3 to_sun = normalised({sun.x / kIndex, sun.y / kIndex, refracted_cosine(height)});
  const float forward = 1.0F + 0.55F * std::pow(std::max(0.0F, dot(direction, to_sun)), 3.0F);
  return (kPhase * forward) * (scattered * here * sum);
}

Rgb Scene::underside_light(Vec3 place, Vec3 direction, float footprint) const {
  const NoiseSample wave = detail_noise(131, place.x, place.y, 3.2F, 5, 0.6F, footprint);
  const Vec3 normal = normalised({-0.22F * wave.dx, -0.22F * wave.dy, 1.0F});
  const float cosine = std::clamp(dot(direction, normal), 0.02F, 1.0F);
  const float sine2 = kIndex * kIndex * (1.0F - cosine * cosine);
  const Vec3 mirrored = normalised(direction - (2.0F * cosine) * normal);
  Rgb below = water_glow(place, mirrored, 1e5F);
  if (mirrored.z < -0.05F) {
    float begin = 0.0F, end = 60.0F;
    const LatticeRay ray = lattice_ray(place, mirrored, 0.0F);
    const float floor = tracer_.clip(ray, begin, end) ? tracer_.trace(ray, begin, end) : -1.0F;
    if (floor >= 0.0F) {
      const Rgb lost = (1.0F / options_.clarity) * (kAbsorption + kScattering);
      const Vec3 there = place + floor * mirrored;
      below = water_glow(place, mirrored, floor) +
              power_of(lost, floor) * land_light(there, mirrored, 2.0F * footprint + 0.02F * floor, {});
    }
  }
  if (sine2 >= 1.0F) return below;
  const float out = std::sqrt(1.0F - sine2);
  const Vec3 sky = normalised(kIndex * direction + (out - kIndex * cosine) * normal);
  const float mirror = fresnel(out);
  Rgb light = sky_.radiance({sky.x, sky.y, std::max(0.02F, sky.z)});
  const float sun = std::max(0.0F, dot(sky, sky_.to_sun()));
  light += (6.0F * std::pow(sun, 350.0F)) * sky_.sun_light();
  return mirror * below + (1.0F - mirror) * light;
}

Rgb Scene::submerged_light(Vec3 from, Vec3 direction, const Hit& hit, float pixel_angle, Dice dice) const {
  if (hit.surface == Surface::deep) return water_glow(from, direction, 1e5F);
  const Vec3 place = from + hit.t * direction;
  const float width = hit.t * pixel_angle;
  Rgb near;
  if (hit.surface == Surface::land) near = land_light(place, direction, width * 1.15F, dice);
  if (hit.surface == Surface::thing) near = thing_light(place, direction, hit.thing, width, dice);
  if (hit.surface == Surface::underside)
    near = underside_light(place, direction, width / std::sqrt(std::max(0.05F, direction.z)));
  const Rgb lost = (1.0F / options_.clarity) * (kAbsorption + kScattering);
  return power_of(lost, hit.t) * near + water_glow(from, direction, hit.t);
}

}  // namespace seamount::render
