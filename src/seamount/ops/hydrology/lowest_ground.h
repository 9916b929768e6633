// Is there ground below a height within a box of cells? Minima of blocks answer where most of the box needs no look.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "seamount/model/grid.h"

namespace seamount::hydrology {

class LowestGround {
 public:
  /// Keeps a reference to the terrain. Linear.
  explicit LowestGround(const HeightField& terrain)
      : terrain_(terrain),
        columns_((terrain.width() + kBlock - 1) / kBlock),
        least_(static_cast<size_t>(columns_) * static_cast<size_t>((terrain.height() + kBlock - 1) / kBlock),
               std::numeric_limits<float>::infinity()) {
    for (int y = 0; y < terrain.height(); ++y)
      for (int x = 0; x < terrain.width(); ++x) note_lowered(x, y);
  }

  /// To call after a cell of the terrain was lowered.
  void note_lowered(int x, int y) {
    float& least = least_[block(x / kBlock, y / kBlock)];
    least = std::min(least, terrain_(x, y));
  }

  /// In columns [x0, x1] and rows [y0, y1]. REQUIRES: they lie in the terrain.
  bool has_below(float height, int x0, int y0, int x1, int y1) const {
    for (int by = y0 / kBlock; by <= y1 / kBlock; ++by) {
      for (int bx = x0 / kBlock; bx <= x1 / kBlock; ++bx) {
        if (!(least_[block(bx, by)] < height)) continue;
        for (int y = std::max(y0, by * kBlock); y <= std::min(y1, by * kBlock + kBlock - 1); ++y)
          for (int x = std::max(x0, bx * kBlock); x <= std::min(x1, bx * kBlock + kBlock - 1); ++x)
            if (terrain_(x, y) < height) return true;
      }
    }
    return false;
  }

 private:
  static constexpr int kBlock = 32;
  size_t block(int bx, int by) const {
    return static_cast<size_t>(by) * static_cast<size_t>(columns_) + static_cast<size_t>(bx);
  }

  const HeightField& terrain_;
  int columns_;
  std::vector<float> least_;
};

}  // namespace seamount::hydrology
