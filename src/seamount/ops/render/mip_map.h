// A grid with its means of 2 x 2, 4 x 4, ... cells, read between cells and between levels: whatever a pixel covers, it
// sees the average.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/model/grid.h"

namespace seamount::render {

/// REQUIRES of Texel: + and multiplication by a float from the left.
template <class Texel>
class MipMap {
 public:
  MipMap() = default;
  MipMap(Grid<Texel> base, const RunContext& run) {
    levels_.push_back(std::move(base));
    while (levels_.back().width() > 1 || levels_.back().height() > 1) levels_.push_back(halved(levels_.back(), run));
  }

  const Grid<Texel>& base() const { return levels_.front(); }

  /// The mean over about 2^lod cells around fractional (column, row) of the base; edges repeat outwards.
  Texel sample(float column, float row, float lod) const {
    const float level = std::clamp(lod, 0.0F, static_cast<float>(levels_.size() - 1));
    const auto lower = static_cast<size_t>(level);
    const float f = level - static_cast<float>(lower);
    const Texel fine = bilinear(lower, column, row);
    if (f < 0.01F || lower + 1 >= levels_.size()) return fine;
    return (1.0F - f) * fine + f * bilinear(lower + 1, column, row);
  }

 private:
  static Grid<Texel> halved(const Grid<Texel>& fine, const RunContext& run) {
    GridFrame frame = fine.frame();
    frame.width = (fine.width() + 1) / 2;
    frame.height = (fine.height() + 1) / 2;
    frame.cell_m *= 2.0;
    Grid<Texel> coarse(frame);
    parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        const int y0 = 2 * y, y1 = std::min(y0 + 1, fine.height() - 1);
        for (int x = 0; x < frame.width; ++x) {
          const int x0 = 2 * x, x1 = std::min(x0 + 1, fine.width() - 1);
          coarse(x, y) = 0.25F * (fine(x0, y0) + fine(x1, y0) + fine(x0, y1) + fine(x1, y1));
        }
      }
    });
    return coarse;
  }

  Texel bilinear(size_t level, float column, float row) const {
    const Grid<Texel>& grid = levels_[level];
    const float scale = 1.0F / static_cast<float>(1U << level);
    const float c = std::clamp((column + 0.5F) * scale - 0.5F, 0.0F, static_cast<float>(grid.width() - 1));
    const float r = std::clamp((row + 0.5F) * scale - 0.5F, 0.0F, static_cast<float>(grid.height() - 1));
    const auto x0 = static_cast<int>(c), y0 = static_cast<int>(r);
    const int x1 = std::min(x0 + 1, grid.width() - 1), y1 = std::min(y0 + 1, grid.height() - 1);
    const float u = c - static_cast<float>(x0), v = r - static_cast<float>(y0);
    return (1.0F - v) * ((1.0F - u) * grid(x0, y0) + u * grid(x1, y0)) +
           v * ((1.0F - u) * grid(x0, y1) + u * grid(x1, y1));
  }

  std::vector<Grid<Texel>> levels_;
};

}  // namespace seamount::render
