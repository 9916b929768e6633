// What tests of networks share: weights by chance, planes of a formula, and the network as architecture.h says it, as
// slow and plain as can be.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/ops/learned/architecture.h"
#include "seamount/ops/learned/planes.h"

namespace seamount::learned {

/// Weights that keep sizes about the same from layer to layer.
inline Weights random_weights(const Architecture& architecture, uint64_t seed = 1) {
  Weights weights;
  describe(architecture, weights);
  uint64_t count = 0;
  for (const Convolution& c : convolutions(architecture)) {
    Rng rng(Seed{1000 * seed + count++});
    Tensor weight{{c.out, c.in, c.kernel, c.kernel}, {}}, bias{{c.out}, {}};
    const double size = std::sqrt(3.0 / (c.in * c.kernel * c.kernel));
    for (int i = 0; i < c.out * c.in * c.kernel * c.kernel; ++i)
      weight.values.push_back(static_cast<float>(rng.uniform(-size, size)));
    for (int i = 0; i < c.out; ++i) bias.values.push_back(static_cast<float>(rng.uniform(-0.2, 0.2)));
    weights.tensors[c.name + ".weight"] = weight;
    weights.tensors[c.name + ".bias"] = bias;
  }
  return weights;
}

/// Smooth waves, a hard square and a cell of its own here and there, other ones in each plane.
inline float plane_value(int x, int y, int plane) {
  const double wave = std::sin(0.11 * x * (1 + plane) + 0.3 * plane) * std::cos(0.07 * y + plane);
  if (plane % 3 == 1) return x % 37 < 12 && y % 29 < 9 ? 1.0F : -1.0F;
  if (plane % 3 == 2) return (x * 31 + y * 17) % 101 == 0 ? 1.0F : 0.0F;
  return static_cast<float>(wave);
}

inline Planes test_planes(int width, int height, int count) {
  return {width, height, count, [=](int begin, int end, std::span<float> values) {
            size_t at = 0;
            for (int y = begin; y < end; ++y)
              for (int x = 0; x < width; ++x)
                for (int p = 0; p < count; ++p) values[at++] = plane_value(x, y, p);
          }};
}

}  // namespace seamount::learned
