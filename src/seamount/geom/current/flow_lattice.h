// A flow on lattices of different steps, and how it comes from one to another.
#pragma once

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// u and v at nodes: level k has one at every 2^k-th cell centre of a grid, from kMargin before the first to kMargin
/// behind the last that a cell needs.
struct FlowLattice {
  static constexpr int kMargin = 5;  ///< what the next finer level's margin is interpolated from

  FlowLattice(const GridFrame& frame, int level_);
  size_t at(int column, int row) const {
    return static_cast<size_t>(row + kMargin) * static_cast<size_t>(columns()) + static_cast<size_t>(column + kMargin);
  }
  int columns() const { return last_column + 1 + 2 * kMargin; }
  int rows() const { return last_row + 1 + 2 * kMargin; }

  int level, last_column, last_row;
  double step_m;
  std::vector<float> u, v;
};

/// Adds a flow to the next finer level: the quintic through six nodes in each direction.
void add_coarser(const FlowLattice& coarse, FlowLattice& fine, const RunContext& run);

/// Lagrange's weights of nodes -2 .. 3 at t in [0, 1].
void quintic_weights(double t, float weights[6]);

/// A picture of `columns` x `rows` numbers on nodes anywhere: the first one x_m east and y_m south of the first cell.
struct NodePicture {
  const float* u;
  const float* v;
  int stride;
  double x_m, y_m, step_m;
};

/// Adds a picture by quintic interpolation. REQUIRES: three of its nodes beyond the lattice's margin on every side.
void add_picture(const NodePicture& picture, FlowLattice& lattice, const RunContext& run);

}  // namespace seamount::geom
