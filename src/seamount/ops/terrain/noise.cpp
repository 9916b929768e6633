#include "seamount/ops/terrain/noise.h"

#include <algorithm>

#include "seamount/base/parallel.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/water/gullies.h"

namespace seamount::terrain {
namespace {

constexpr double kHeight_m = 400.0;  ///< of smooth and ridged noise
constexpr double kSteepness = 0.25;  ///< height of mountains over their wavelength
constexpr int kBroadOctaves = 4;     ///< of what the valleys are cut into
constexpr double kBroadGain = 0.42;
constexpr float kSpread = 0.75F;        ///< noise from minus to plus this goes from the lowest to the highest ground
constexpr float kLowest = 0.1F;         ///< share of the height at which the lowest ground lies
constexpr double kValleySpacing = 0.4;  ///< over the wavelength
constexpr double kValleyDepth = 0.85;

double height_of(const NoiseParams& params) {
  return params.height_m.value_or(params.kind == NoiseKind::mountains ? kSteepness * params.wavelength_m : kHeight_m);
}

/// Share of the height for noise: level where it is low, ever steeper where it is high.
float share_of(float noise) {
  const float t = std::clamp(0.5F + 0.5F * noise / kSpread, 0.0F, 1.2F);
  return kLowest + (1.0F - kLowest) * t * (0.2F * t * t + 0.5F * t + 0.3F);
}

HeightField mountains(const NoiseParams& params, const GridFrame& frame, Seed seed, const RunContext& run) {
  const geom::Fbm broad{.wavelength_m = params.wavelength_m,
                        .octaves = std::min(params.octaves, kBroadOctaves),
                        .gain = kBroadGain * params.gain / 0.5,
                        .cell_m = frame.cell_m};
  const double height = height_of(params);
  HeightField out(frame);
  parallel_rows(run.part(0.0, 0.2), frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const auto row = out.row(y);
      geom::fbm_row(seed, broad, frame, y, row);
      for (float& z : row) z = static_cast<float>(params.base_m + height * static_cast<double>(share_of(z)));
    }
  });
  if (height == 0) return out;  // level to the bit
  const geom::Gullies valleys{.wavelength_m = kValleySpacing * params.wavelength_m,
                              .octaves = std::min(params.octaves, 12),
                              .gain = params.gain,
                              .strength = kValleyDepth,
                              .sharpness = 0.5};
  geom::add_gullies(out, seed.derive("valleys"), valleys, ScalarField(frame, 1.0F), run.part(0.2, 1.0));
  return out;
}

}  // namespace

Reach noise_reach(const NoiseParams& params, double cell_m) {
  if (params.kind != NoiseKind::mountains) return Reach::place();
  return geom::gullies_reach(kValleySpacing * params.wavelength_m, cell_m);
}

HeightField noise(const NoiseParams& params, const GridFrame& frame, Seed seed, const RunContext& run) {
  check_params(params);
  const Seed own = seed.derive("terrain.noise");
  if (params.kind == NoiseKind::mountains) return mountains(params, frame, own, run);
  const geom::Fbm shape{
      .wavelength_m = params.wavelength_m, .octaves = params.octaves, .gain = params.gain, .cell_m = frame.cell_m};
  const double height = height_of(params);
  HeightField out(frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const auto row = out.row(y);
      if (params.kind == NoiseKind::ridged) {
        geom::ridged_row(own, shape, frame, y, row);
      } else {
        geom::fbm_row(own, shape, frame, y, row);
      }
      for (float& z : row) z = static_cast<float>(params.base_m + height * z);
    }
  });
  return out;
}

}  // namespace seamount::terrain
