#include "seamount/ops/learned/layers.h"

#include <algorithm>
#include <string>

namespace seamount::learned {
namespace {

/// The weights of `input` for planes that stand together (rows.h, halve): from channel 4 c + 2 dy + dx to
/// (2 dy + dx) planes + c.
Tensor for_halved(const Tensor& weight, int planes) {
  Tensor out = weight;
  for (int64_t o = 0; o < weight.shape[0]; ++o) {
    for (int c = 0; c < planes; ++c) {
      for (int d = 0; d < 4; ++d) {
        const int64_t from = (o * 4 * planes + 4 * c + d) * 9, to = (o * 4 * planes + d * planes + c) * 9;
        std::copy_n(weight.values.begin() + from, 9, out.values.begin() + to);
      }
    }
  }
  return out;
}

After after(const std::string& name) {
  if (name.starts_with("lift") || name == "thin") return After::nothing;
  return name == "middle" || name.starts_with("deep") ? After::add_relu : After::relu;
}

}  // namespace

Layers make_layers(const Weights& weights, bool bf16) {
  Layers layers;
  layers.architecture = architecture_of(weights);
  layers.bf16 = bf16;
  for (const Convolution& shape : convolutions(layers.architecture)) {
    const Tensor &weight = weights.tensors.at(shape.name + ".weight"), &bias = weights.tensors.at(shape.name + ".bias");
    if (shape.name == "outer") {
      layers.outer_weight.resize(weight.values.size());
      for (int c = 0; c < kInnerWidth; ++c)
        for (int tap = 0; tap < 9; ++tap) layers.outer_weight[tap * kInnerWidth + c] = weight.values[c * 9 + tap];
      layers.outer_bias = bias.values[0];
      continue;
    }
    const Tensor& order = shape.name == "input" ? for_halved(weight, layers.architecture.planes) : weight;
    layers.convolvers.emplace(shape.name,
                              Convolver(shape, order, bias, after(shape.name), bf16, shape.name == "inner"));
  }
  return layers;
}

}  // namespace seamount::learned
