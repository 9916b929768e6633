// Terrains to draw in tests and benchmarks: formulas, not methods of the library.
#pragma once

#include <algorithm>
#include <cmath>

#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"
#include "seamount/ops/render/colour.h"
#include "seamount/ops/render/detail_noise.h"

namespace seamount::render {

/// Value in [0, 1] with sharp crests, from metres.
inline float test_ridges(float x, float y, float wavelength, float footprint) {
  float sum = 0.0F, weight = 0.5F, previous = 1.0F;
  for (int i = 0; i < 8 && wavelength > 2.0F * footprint; ++i) {
    const float crest =
        1.0F - 2.2F * std::abs(gradient_noise(7U + static_cast<uint32_t>(i), x / wavelength, y / wavelength).value);
    sum += weight * crest * previous;
    previous = clamp01(crest);
    weight *= 0.5F;
    wavelength *= 0.5F;
  }
  return sum;
}

/// A volcanic island of `size_m` across with radial ridges, beach, lagoon at -15 m, a barrier reef at -1.5 m with two
/// passes and a fore reef to -800 m. `peak_m` = 0 makes an atoll.
inline HeightField test_island(int width, int height, double size_m, double peak_m) {
  HeightField terrain(GridFrame::centred(width, height, size_m / std::max(width, height)));
  const auto size = static_cast<float>(size_m), peak = static_cast<float>(peak_m);
  const auto cell = static_cast<float>(terrain.cell_m());
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const auto x = static_cast<float>(terrain.frame().x(column)), y = static_cast<float>(terrain.frame().y(row));
      const NoiseSample bend = detail_noise(3, x, y, 0.35F * size, 6, 0.5F, cell);
      const NoiseSample bend2 = detail_noise(5, x, y, 0.20F * size, 7, 0.5F, cell);
      const float angle = std::atan2(y, x);
      const float lobes = 1.0F + 0.10F * std::sin(2.0F * angle + 0.7F) + 0.06F * std::sin(5.0F * angle);
      const float r = std::hypot(x, y) / (0.5F * size * lobes) + 0.16F * bend.value;
      const float shore = 0.46F + 0.09F * bend2.value, rim = 0.72F + 0.03F * bend2.value;
      float h = 0.0F;
      if (r < shore && peak > 0.0F) {
        const float inland = 1.0F - r / shore;
        const float ridges = test_ridges(x + 900.0F * bend2.value, y + 900.0F * bend.value, 0.22F * size, cell);
        h = 2.5F * std::min(1.0F, 12.0F * inland) +
            peak * std::pow(inland, 1.25F) * (0.30F + 0.95F * ridges) * ramp(0.01F, 0.12F, inland);
      } else if (r < rim) {
        const float edge = std::min(peak > 0.0F ? (r - shore) / 0.05F : 1.0F, (rim - r) / 0.04F);
        h = -0.6F - (14.0F + 6.0F * detail_noise(9, x, y, 900.0F, 4, 0.5F, cell).value) * ramp(0.0F, 1.0F, edge);
      } else {
        const float out = r - rim;
        const float pass = std::min(std::abs(angle + 1.9F), std::abs(angle - 0.6F));
        const float crest = -1.5F - 20.0F * ramp(0.05F, 0.02F, pass) + 0.8F * bend2.value;
        h = out < 0.03F ? crest
                        : crest - 800.0F * (1.0F - std::exp(-(out - 0.03F) / 0.11F)) * (1.0F + 0.3F * bend.value);
      }
      terrain(column, row) = h;
    }
  }
  return terrain;
}

/// Mountains without sea.
inline HeightField test_alps(int width, int height, double size_m) {
  HeightField terrain(GridFrame::centred(width, height, size_m / std::max(width, height)));
  const auto size = static_cast<float>(size_m), cell = static_cast<float>(terrain.cell_m());
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const auto x = static_cast<float>(terrain.frame().x(column)), y = static_cast<float>(terrain.frame().y(row));
      terrain(column, row) = 900.0F + 2600.0F * test_ridges(x, y, 0.3F * size, cell) +
                             500.0F * detail_noise(3, x, y, 0.5F * size, 4, 0.5F, cell).value;
    }
  }
  return terrain;
}

/// Labels of a terrain by height alone.
inline LabelMap test_labels(const HeightField& terrain) {
  LabelMap labels(terrain.frame());
  for (size_t i = 0; i < terrain.size(); ++i) {
    const float h = terrain.cells()[i];
    labels.cells()[i] = h > 3.0F    ? Region::mountain
                        : h > 0.0F  ? Region::beach
                        : h > -3.0F ? Region::reef
                        : h > -30.F ? Region::lagoon
                                    : Region::abyss;
  }
  return labels;
}

}  // namespace seamount::render
