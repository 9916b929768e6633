#include "seamount/ops/render/water.h"

#include "seamount/ops/render/detail_noise.h"

namespace seamount::render {
namespace {

constexpr Rgb kAttenuation{0.200F, 0.0335F, 0.0245F};  // per metre, clear tropical coastal water in broad bands
constexpr Rgb kDeepReflectance{0.0020F, 0.0165F, 0.0480F};
constexpr Rgb kFoam{0.78F, 0.80F, 0.80F};
constexpr float kPi = 3.14159265F;
constexpr float kMostGlint = 0.36F;  // what an eye or a film that is set for the land still tells from white

/// Variance of the slopes of waves: Cox and Munk at a breeze of 6 m/s, less in shelter, in gusts and lulls.
float slope_variance(const WaterPoint& p) {
  constexpr float kOpen = 0.003F + 0.00512F * 6.0F;
  const float gusts = detail_noise(137, p.x, p.y, 2100.0F, 3, 0.6F, p.footprint).value;
  return kOpen * clamp01(0.85F + 0.9F * gusts) * mix(1.0F, 0.35F, p.shelter) + 0.003F;
}

float mean_fresnel(float cosine, float variance) {
  const float sigma = std::sqrt(variance);
  const float power = 5.0F * std::exp(-2.69F * sigma);
  return 0.02F + 0.98F * std::pow(1.0F - cosine, power) / (1.0F + 22.7F * std::pow(sigma, 1.5F));
}

/// How much more surface waves show than they hide, Smith's function for Gaussian slopes.
float hidden_share(float cosine, float variance) {
  const float sine = std::sqrt(std::max(1e-6F, 1.0F - cosine * cosine));
  const float a = cosine / (sine * std::sqrt(variance));
  if (a > 2.5F) return 0.0F;
  return 0.5F * (std::exp(-a * a) / (a * std::sqrt(kPi)) - std::erfc(a));
}

float fresnel(float cosine) {
  const float c = 1.0F - cosine;
  return 0.02F + 0.98F * c * c * c * c * c;
}

Rgb body(Rgb floor, float path, float clarity) {
  const Rgb through = water_transmittance(path, clarity);
  return kDeepReflectance + through * (0.80F * floor - kDeepReflectance);
}

}  // namespace

float sun_glint(Vec3 to_eye, Vec3 normal, Vec3 to_sun, float variance) {
  const Vec3 half = normalised(to_eye + to_sun);
  const float tilt = dot(half, normal);
  if (tilt < 0.5F) return 0.0F;
  const float slope2 = (1.0F - tilt * tilt) / (tilt * tilt);
  const float density = std::exp(-slope2 / variance) / (kPi * variance);
  const float eye = std::max(0.02F, dot(normal, to_eye)), sun = std::max(0.02F, to_sun.z);
  const float seen = 1.0F / (1.0F + hidden_share(eye, variance) + hidden_share(sun, variance));
  const float tilt2 = tilt * tilt;
  const float glint = kPi * fresnel(dot(half, to_sun)) * density * seen / (4.0F * eye * tilt2 * tilt2);
  return glint / (1.0F + glint / kMostGlint);
}

Rgb water_transmittance(float path_m, float clarity) { return exp_of((-path_m / clarity) * kAttenuation); }

Rgb river_bed() { return {0.105F, 0.092F, 0.066F}; }

float refracted_cosine(float cosine) { return std::sqrt(1.0F - (1.0F - cosine * cosine) / (1.333F * 1.333F)); }

Rgb reflectance_from_above(Rgb floor, float depth, float sun_height, float clarity) {
  return body(floor, depth * (1.0F + 1.0F / refracted_cosine(sun_height)), clarity);
}

float foam_share(float x, float y, float footprint, float depth, float breaking, float exposed) {
  const float noise = detail_noise(113, x, y, 140.0F, 4, 0.65F, footprint).value;
  const float wash = ramp(1.4F, 0.1F, depth + 0.8F * noise) * (0.25F + 0.45F * exposed);
  const float surf = ramp(4.5F, 1.5F, depth + 2.5F * noise) * breaking;
  return clamp01(0.8F * std::max(wash, surf) * clamp01(0.75F + 1.2F * noise));
}

Rgb water_light(const WaterPoint& p, const Sky& sky, float clarity) {
  const Vec3 sun = sky.to_sun();
  const float sun_height = std::max(0.02F, sun.z);
  const float eye_height = std::max(0.01F, p.to_eye.z);
  const float lit = p.sun * (1.0F - fresnel(sun_height)) * sun_height;
  const Rgb down = lit * sky.sun_light() + p.sky * sky.sky_light();
  const float path = p.depth * (1.0F / refracted_cosine(eye_height) + 1.0F / refracted_cosine(sun_height));

  // Waves long enough to be seen tilt the surface; the shorter ones are in the statistics.
  const float variance = slope_variance(p);
  const float height = 5.2F * std::sqrt(variance) * ramp(0.0F, 3.0F, p.depth);
  const NoiseSample wave = detail_noise(131, p.x, p.y, 70.0F, 9, 0.55F, p.footprint);
  const Vec3 normal = normalised({-height * wave.dx, -height * wave.dy, 1.0F});
  const float cosine = std::max(0.02F, dot(normal, p.to_eye));
  const float mirror = mean_fresnel(cosine, variance);
  Vec3 reflected = 2.0F * dot(normal, p.to_eye) * normal - p.to_eye;
  reflected.z = std::max(0.06F, reflected.z + 0.10F);  // the mean over waves looks higher
  Rgb light = (1.0F - mirror) * (body(p.floor, path, clarity) * down) +
              (mirror * (0.4F + 0.6F * p.sky)) * sky.radiance(normalised(reflected));
  light += (p.glint * p.sun * sun_glint(p.to_eye, normal, sun, variance)) * sky.sun_light();
  return mix(light, kFoam * down, p.foam);
}

}  // namespace seamount::render
