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

/// The weights of `inner` for two cells side by side at once, of 3x2 pairs of cells: as many results as a vector has
/// numbers. The left pair of inputs begins a cell before the pair of results.
Tensor for_pairs(const Tensor& weight) {
  const int64_t outs = weight.shape[0], ins = weight.shape[1];
  Tensor out{{2 * outs, 2 * ins, 3, 2}, std::vector<float>(static_cast<size_t>(24 * outs * ins))};
  for (int64_t o = 0; o < 2 * outs; ++o) {
    for (int64_t i = 0; i < 2 * ins; ++i) {
      for (int64_t tap = 0; tap < 6; ++tap) {
        const int64_t column = 2 * (tap % 2) + i / ins - o / outs;  // of the kernel
        if (column < 0 || column > 2) continue;
        out.values[(o * 2 * ins + i) * 6 + tap] =
            weight.values[((o % outs * ins + i % ins) * 3 + tap / 2) * 3 + column];
      }
    }
  }
  return out;
}

Tensor twice(Tensor bias) {
  bias.shape[0] *= 2;
  const std::vector<float> values = bias.values;
  bias.values.insert(bias.values.end(), values.begin(), values.end());
  return bias;
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
    const bool inner = shape.name == "inner";
    const Tensor order = inner                   ? for_pairs(weight)
                         : shape.name == "input" ? for_halved(weight, layers.architecture.planes)
                                                 : weight;
    layers.convolvers.emplace(
        shape.name, Convolver(order, inner ? twice(bias) : bias, shape.stride, after(shape.name), bf16, inner));
  }
  return layers;
}

}  // namespace seamount::learned
