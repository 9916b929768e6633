// A grid at half, a quarter, an eighth ... of its resolution, and the way back.
#pragma once

#include <cstddef>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Means of 2 x 2 cells; the last column or row of an odd grid stands for itself. Same north-western corner: a window
/// that begins at even cells of its whole becomes one of the whole's half. Parallel.
Grid<float> halved(const Grid<float>& grid, const RunContext& run);

/// Catmull-Rom interpolation to cells of half the size. REQUIRES: grid has the size that halved() makes of `frame`,
/// which is the result's. Parallel.
Grid<float> doubled(const Grid<float>& grid, const GridFrame& frame, const RunContext& run);

/// A grid and its halvings; level 0 is the grid itself, which must outlive the pyramid.
class Pyramid {
 public:
  explicit Pyramid(const Grid<float>& finest) : finest_(finest) {}
  const Grid<float>& operator[](size_t level) const { return level == 0 ? finest_ : halvings_[level - 1]; }
  /// The coarsest level there is.
  size_t top() const { return halvings_.size(); }
  void grow(const RunContext& run) { halvings_.push_back(halved((*this)[top()], run)); }

 private:
  const Grid<float>& finest_;
  std::vector<Grid<float>> halvings_;
};

}  // namespace seamount::geom
