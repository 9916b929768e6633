// Batches, losses and measures of the training loop.
#pragma once

#include <torch/torch.h>

#include <array>
#include <vector>

#include "seamount/train/sample.h"
#include "seamount/train/training.h"

namespace seamount::train {

inline constexpr int kHeightPlanes = 3;  ///< height and slopes, that the critic sees

/// [batch, planes or 1, size, size].
struct Batch {
  torch::Tensor planes, base, target, weight;
  Batch to(torch::Device device) const {
    return {planes.to(device), base.to(device), target.to(device), weight.to(device)};
  }
};

Batch as_tensors(const std::vector<Sample>& samples);

struct Losses {
  double l1 = 0, slopes = 0, critic = 0, judgement = 0, features = 0;
  Losses& operator+=(const Losses& other);
  Losses operator/(int count) const;
};

/// L1 over means of 1 to 32 cells and slopes; those below 4 cells by `fine`.
torch::Tensor pyramid_loss(const torch::Tensor& made, const Batch& batch, double fine, Losses& losses);

/// Height above the map's mean, slopes, and drawn planes.
torch::Tensor critic_view(const torch::Tensor& z, const torch::Tensor& planes, const std::vector<int>& drawn);

/// Energy of differences at 2 to 32 cells, made and real.
struct Spectrum {
  std::array<double, 5> made{}, real{};
  double distance() const;
};

/// Adds a batch's errors (sums over its samples) and energies.
void measure(const torch::Tensor& made, const Batch& batch, Check& check, Spectrum& spectrum);

}  // namespace seamount::train
