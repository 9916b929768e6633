// The network of ops/learned/architecture.h and its critic, in libtorch.
#pragma once

#include <torch/torch.h>

#include <map>
#include <string>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/model/weights.h"
#include "seamount/ops/learned/architecture.h"

namespace seamount::train {

using Tensors = std::map<std::string, torch::Tensor>;

/// Random tensors of an architecture (He et al. 2015), the last convolution zero: the network begins as no change.
Tensors random_generator(const learned::Architecture& architecture, Seed seed);
Tensors from_weights(const learned::Architecture& architecture, const Weights& weights);
Weights to_weights(const learned::Architecture& architecture, const Tensors& tensors);

/// planes: [batch, planes, height, width] in f32, sides multiples of the stride; the network's plane in f32.
/// Convolutions compute in `type`.
torch::Tensor generate(const learned::Architecture& architecture, const Tensors& tensors, const torch::Tensor& planes,
                       torch::ScalarType type);

/// A critic of patches with spectral norm.
struct Critic {
  Tensors tensors;  ///< weights and biases
  Tensors norms;    ///< the vectors of the power iteration, no parameters

  static Critic random(int planes, Seed seed);
  /// Features of each layer; the last is the judgement, > 0 for real.
  std::vector<torch::Tensor> judge(const torch::Tensor& seen, torch::ScalarType type) const;
  /// One step of the power iteration, before each step of the training.
  void update_norms();
};

/// Bilinear doubling between cell centres, clamped at the edge.
torch::Tensor doubled(const torch::Tensor& x);

}  // namespace seamount::train
