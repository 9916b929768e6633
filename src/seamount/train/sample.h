// What a training loop asks of a task: samples by number, without knowing what they show.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "seamount/ops/learned/architecture.h"

namespace seamount::train {

/// One example: what the network sees, and what it should have made of it. Squares of `size` cells.
struct Sample {
  int size = 0;
  std::vector<float> planes;  ///< channels last, as learned::Planes::fill() writes them
  std::vector<float> base;    ///< what the network's plane is added to
  std::vector<float> target;  ///< what the sum should be, in the unit of `base`
  std::vector<float> weight;  ///< how much a cell counts, [0, 1]
};

/// Sample n is a function of (task, n) alone, so that a training goes on after a kill with the samples that it would
/// have had. Both may be called by several threads at once.
class Task {
 public:
  virtual ~Task() = default;
  virtual std::string name() const = 0;  ///< "sketch"
  virtual learned::Architecture architecture() const = 0;
  virtual std::vector<int> drawn_planes() const = 0;  ///< that the critic sees beside the heights
  virtual Sample training(uint64_t n) const = 0;
  virtual Sample held_out(uint64_t n) const = 0;  ///< of ground that training() never shows
};

}  // namespace seamount::train
