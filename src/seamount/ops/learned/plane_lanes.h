// One row of a map's planes, each for itself while it is computed, so that the compiler can make vectors of them.
#pragma once

#include <cstddef>
#include <vector>

#include "seamount/model/grid.h"

namespace seamount::learned {

class PlaneLanes {
 public:
  /// All 0.
  PlaneLanes(int width, int planes)
      : width_(static_cast<size_t>(width)), planes_(static_cast<size_t>(planes)), values_(width_ * planes_, 0.0F) {}

  float* operator[](int plane) { return values_.data() + static_cast<size_t>(plane) * width_; }

  /// Writes them as Planes::fill does: the planes of a cell together.
  void interleave(float* out) const {
    for (size_t x = 0; x < width_; ++x)
      for (size_t k = 0; k < planes_; ++k) out[x * planes_ + k] = values_[k * width_ + x];
  }

 private:
  size_t width_, planes_;
  std::vector<float> values_;
};

}  // namespace seamount::learned
