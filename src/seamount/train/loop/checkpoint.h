// Everything that a training needs to go on as if it had never stopped, in one file.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "seamount/train/loop/generator.h"
#include "seamount/train/training.h"

namespace seamount::train {

/// Of Adam, for one tensor.
struct Moments {
  torch::Tensor first, second;
  static Moments zeros(const torch::Tensor& like) { return {torch::zeros_like(like), torch::zeros_like(like)}; }
};

struct TrainingState {
  int64_t samples = 0;
  int checks_since_best = 0;
  Check best;
  Tensors generator, average;
  Critic critic;
  std::map<std::string, Moments> moments;
};

/// Whether the processor convolves in bf16 (AVX-512 BF16).
bool has_bf16();

/// As safetensors (io/weights.h), in f32. Throws WriteError.
void write_checkpoint(const TrainingState& state, const std::string& path);

/// Into a state that has every tensor already: all must be in the file with the same shape. Throws IoError.
void read_checkpoint(const std::string& path, TrainingState& state);

/// The critic that belongs to weights, in a file of its own beside them, so that a training can go on from shipped
/// weights.
std::string critic_file(const std::string& weights_file);
Weights critic_weights(const Critic& critic);
/// Into a critic that has every tensor already. Throws IoError.
void read_critic(const std::string& path, Critic& critic);

}  // namespace seamount::train
