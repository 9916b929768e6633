#include "seamount/ops/render/shading.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/ops/render/colour.h"
#include "seamount/ops/render/light.h"

namespace seamount::render {
namespace {

/// A light's direction (x east, y north, z up) and its share.
struct Light {
  float x, y, z, share;
};

std::array<Light, 4> lights(const ShadingOptions& options) {
  constexpr std::array<std::array<double, 2>, 4> kTurnAndShare = {
      {{0.0, 0.55}, {-0.85, 0.18}, {0.85, 0.18}, {2.6, 0.09}}};
  std::array<Light, 4> result{};
  for (size_t i = 0; i < result.size(); ++i) {
    const double azimuth = options.light_azimuth + kTurnAndShare[i][0];
    const double flat = std::cos(options.light_elevation);
    result[i] = {static_cast<float>(flat * std::sin(azimuth)), static_cast<float>(flat * std::cos(azimuth)),
                 static_cast<float>(std::sin(options.light_elevation)), static_cast<float>(kTurnAndShare[i][1])};
  }
  return result;
}

struct SlopeSums {
  double squares = 0.0;
  int64_t count = 0;
  SlopeSums& operator+=(const SlopeSums& other) {
    squares += other.squares;
    count += other.count;
    return *this;
  }
};

/// Root mean square slope of the ground that is not nearly level, in tangent; 0 for a plain.
double typical_slope(const HeightField& terrain, const RunContext& run) {
  if (terrain.width() < 2 || terrain.height() < 2) return 0.0;
  const auto body = [&](int64_t begin, int64_t end) {
    SlopeSums sums;
    for (auto y = static_cast<int>(begin); y < end; ++y) {
      for (int x = 0; x + 1 < terrain.width(); ++x) {
        const double east = terrain(x + 1, y) - terrain(x, y), south = terrain(x, y + 1) - terrain(x, y);
        const double square = (east * east + south * south) / (terrain.cell_m() * terrain.cell_m());
        if (square < 4e-4) continue;
        sums.squares += std::min(square, 4.0);
        ++sums.count;
      }
    }
    return sums;
  };
  const auto sums = parallel_sum<SlopeSums>(run, terrain.height() - 1, 64, body);
  return sums.count == 0 ? 0.0 : std::sqrt(sums.squares / static_cast<double>(sums.count));
}

float lambert(const HeightField& h, int x, int y, float scale, const std::array<Light, 4>& from) {
  const float east = scale * (h.clamped(x + 1, y) - h.clamped(x - 1, y));
  const float north = scale * (h.clamped(x, y - 1) - h.clamped(x, y + 1));
  const float inverse = 1.0F / std::sqrt(1.0F + east * east + north * north);
  float sum = 0.0F;
  for (const Light& light : from) {
    sum += light.share * std::max(0.0F, inverse * (light.z - east * light.x - north * light.y));
  }
  return sum / from[0].z;
}

}  // namespace

Grid<float> relief_shading(const HeightField& terrain, const ShadingOptions& options, const RunContext& run) {
  const double slope = typical_slope(terrain, run);
  const double exaggeration = options.exaggeration.value_or(slope > 0.0 ? std::clamp(0.62 / slope, 0.3, 12.0) : 1.0);
  HeightField broad = terrain;
  geom::gaussian_blur(broad, 5.0 * terrain.cell_m(), run);
  HeightField raised = terrain;
  for (float& h : raised.cells()) h *= static_cast<float>(exaggeration);
  const Grid<float> sky = openness(raised, run).sky;
  const std::array<Light, 4> from = lights(options);
  const auto scale = static_cast<float>(0.5 * exaggeration / terrain.cell_m());
  const auto ambient = static_cast<float>(options.ambient);
  Grid<float> shade(terrain.frame());
  parallel_rows(run, terrain.width(), terrain.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < terrain.width(); ++x) {
        const float direct =
            0.66F * lambert(terrain, x, y, scale, from) + 0.34F * lambert(broad, x, y, 1.4F * scale, from);
        const float soft = direct < 1.0F ? 1.0F - 0.80F * (1.0F - direct) : 1.0F + 1.5F * (direct - 1.0F);
        shade(x, y) = soft * (1.0F - ambient * 0.75F * (1.0F - sky(x, y)));
      }
    }
  });
  return shade;
}

}  // namespace seamount::render
