// Upsampling row by row: a smooth field kept on a coarse lattice, read along the rows of a finer frame. Catmull-Rom
// both ways, once differentiable, vectorised. For fields whose forms are several lattice cells wide.
#pragma once

#include <span>
#include <vector>

#include "seamount/model/grid.h"

namespace seamount::geom {

/// The frame's area in cells at least `cell_m` wide: the frame itself if its cells are that large, else its
/// north-western corner with larger cells.
GridFrame coarser_frame(const GridFrame& frame, double cell_m);

/// Reads rows; keeps its scratch, so use one per thread. The lattice must outlive it.
class RowUpsampler {
 public:
  explicit RowUpsampler(const ScalarField& lattice);
  /// out[i] = field at (x0 + i dx, y), metres; beyond the lattice its nearest node.
  void read(double x0, double dx, double y, std::span<float> out);

 private:
  const ScalarField& lattice_;
  std::vector<float> line_;  ///< one lattice row, two nodes of margin on both sides
};

}  // namespace seamount::geom
