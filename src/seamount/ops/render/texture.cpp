#include "seamount/ops/render/texture.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/ops/render/ground.h"
#include "seamount/ops/render/water.h"

namespace seamount::render {
namespace {

constexpr SunDirection kSun{5.4978, 0.87};  // north-west, 50 degrees high

constexpr float kDaylight = 2.0F;  // brightness of a picture that is its own light, over that of an albedo

/// Brightness of soft light, 1 on open level ground.
float soft_light(const GroundSample& s, Vec3 normal, Vec3 to_sun) {
  const float direct = std::max(0.0F, dot(normal, to_sun)) / to_sun.z;
  return (0.45F + 0.55F * direct * (0.5F + 0.5F * s.form.sun)) * (0.45F + 0.55F * s.cover.sky);
}

Rgb texel(const Ground& ground, const Sky& sky, const TextureParams& params, const MaterialRules& rules, float x,
          float y, float footprint) {
  const GroundSample s = ground.sample(x, y, footprint);
  SurfacePoint point = s.point;
  if (!params.water) point.z = std::max(point.z, 5.0F);
  if (point.lake > 0.0F) point.z = -point.lake;
  const Material material = ground_material(point, rules);
  const float light = soft_light(s, ground.normal(s, material.bump), sky.to_sun());
  const auto baked = static_cast<float>(params.baked_light);
  Rgb colour = mix(1.0F, light, baked) * material.albedo + 0.5F * material.glow;
  if (params.water && point.z < 0.0F) {
    colour = reflectance_from_above(colour, -point.z, sky.to_sun().z, static_cast<float>(params.water_clarity));
  }
  if (point.river > 0.0F && point.z > 0.0F)
    colour = mix(colour, reflectance_from_above(river_bed(), kRiverDepth_m, sky.to_sun().z, 0.3F), point.river);
  return mix(1.0F, kDaylight, baked) * colour;
}

}  // namespace

Image texture(const HeightField& terrain, const Shown& shown, const TextureParams& params, const RunContext& run) {
  check_params(params);
  const Climate climate = climate_of(params.climate, params.tree_line_m, params.snow_line_m, params.rock,
                                     setting_of(terrain, params.water_level_m, params.water));
  const MaterialRules rules{climate, params.style};
  const Ground ground(terrain, shown.labels,
                      {.water_level_m = params.water_level_m,
                       .sun = kSun,
                       .limit = std::max(16, params.size_px),
                       .style = params.style,
                       .layers = params.layers,
                       .lake = params.water ? shown.lake : nullptr,
                       .rivers = params.water ? shown.rivers : nullptr,
                       .min_sea_m2 = params.min_sea_m2,
                       .wind_from = climate.wind_from},
                      run.part(0.0, 0.4));
  const Sky sky(kSun);
  const double width_m = terrain.frame().width_m(), height_m = terrain.frame().height_m();
  const double pixel_m = std::max(width_m, height_m) / params.size_px;
  Image image(std::max(1, static_cast<int>(std::lround(width_m / pixel_m))),
              std::max(1, static_cast<int>(std::lround(height_m / pixel_m))));
  parallel_rows(run.part(0.4, 1.0), image.width, image.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      run.check_cancelled();
      for (int x = 0; x < image.width; ++x) {
        const double east = ((x + 0.5) / image.width - 0.5) * width_m;
        const double north = (0.5 - (y + 0.5) / image.height) * height_m;
        write_dithered(image.pixel(x, y), x, y,
                       texel(ground, sky, params, rules, static_cast<float>(east), static_cast<float>(north),
                             static_cast<float>(pixel_m)));
      }
    }
  });
  return image;
}

}  // namespace seamount::render
