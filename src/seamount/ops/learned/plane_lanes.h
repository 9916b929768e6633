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
      : width_(width),
        planes_(planes),
        stride_(stride_of(width)),
        values_(stride_ * static_cast<size_t>(planes), 0.0F) {}

  float* operator[](int plane) { return values_.data() + static_cast<size_t>(plane) * stride_; }

  /// Writes them as Planes::fill does: the planes of a cell together.
  void interleave(float* out) const;

 private:
  /// Cache lines of a lane are an odd number, or else all lanes would fight for the same places of the cache.
  static size_t stride_of(int width) {
    const size_t lines = (static_cast<size_t>(width) + 15) / 16;
    return 16 * (lines + 1 - lines % 2);
  }

  int width_, planes_;
  size_t stride_;
  std::vector<float> values_;
};

}  // namespace seamount::learned
