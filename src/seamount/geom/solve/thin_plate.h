// Thin-plate smoothing between two bounds (a double obstacle problem).
//
// Sweeps of accelerated projected gradients (Beck and Teboulle 2009) on the bending energy
//
//   sum h_xx^2 + 2 h_xy^2 + h_yy^2   where  low <= h <= high,
//
// of a plate that is free at the frame's edge. Every sweep is elementwise and stays within the bounds; k of them smooth
// over about k / 2 cells.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// `start` after some sweeps. A plane within the bounds stays as it is. REQUIRES: grids of one size, low <= high, all
/// finite. Parallel; two copies of the grid besides the three, about 4 ns a cell and sweep.
HeightField smooth_thin_plate(HeightField start, const HeightField& low, const HeightField& high, int sweeps,
                              const RunContext& run);

}  // namespace seamount::geom
