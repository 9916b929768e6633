// What rivers make of a terrain if they keep their ways: one implicit step of cutting and laying down, however long.
//
//   dh/dt = - K sqrt(Q) dh/dx + G q_s / Q,   dh/dx <= S / (1 + s log2(1 + A / A_h))
//
// From the outlets up (Braun and Willett 2013), with the load by Gauss-Seidel sweeps (Yuan et al. 2019). An estimate
// in a few passes of what erosion.run does in many, where ways shift, valleys of all sizes grow and soil creeps.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

struct Incision {
  float rate = 0.0F;        ///< K t sqrt(runoff): times the root of the cells drained the cut in cells' widths, >= 0
  float deposition = 1.0F;  ///< G, >= 0
  float steepest = 1e9F;    ///< S, rise over run, > 0
  float hollowed = 0.0F;    ///< s: by how much each doubling of the water makes a hollow gentler, >= 0
  float hollow_cells = 1;   ///< A_h, > 0
  float channel_cells = 0;  ///< drained without a channel, >= 0
  int sweeps = 2;           ///< for the load, >= 0
};

struct Incised {
  HeightField heights;
  ScalarField load;  ///< metres of thickness on one cell that have passed it
};

/// REQUIRES: directions without pits, as of the filled terrain, and their flow_accumulation(). Outlets stay. What is
/// laid down is what was cut: the heights' sum falls by what reaches the outlets, to rounding. Mostly one thread, about
/// 60 ns and 36 bytes per cell.
Incised incise(const HeightField& terrain, const FlowDirections& directions, const Grid<uint32_t>& cells,
               const Incision& incision, const RunContext& run);

/// Lowers heights until none rises more steeply than `incision` lets it over its neighbours, as rock that fails does: S
/// in the direction of the slope (Zhao 2005), two sweeps, exact but where ways bend around higher ground. The border
/// stays. One thread, 30 ns per cell.
void limit_rise(HeightField& heights, const Grid<uint32_t>& cells, const Incision& incision, const RunContext& run);

}  // namespace seamount::geom
