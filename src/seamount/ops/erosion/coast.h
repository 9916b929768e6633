// The coast: waves cut cliffs back and shoals down, and what rivers and waves bring settles on the sea floor.
//
// Cliff retreat: waves move the shore inland at a rate in metres per year that grows with its exposure (the share of
// open sea around it, a proxy of fetch) and falls with hardness; what stands there goes into the water (Sunamura 1992).
// Below water, waves plane the floor down to their base. Loads spread over the sea around where they enter it, a third
// of them near, as deltas, the rest far, and settle less where waves stir the water, nowhere above the profile that
// waves keep: a depth of 0.1 m^(1/3) x^(2/3) at x metres from the shore (Dean 1991, fine sand), times the exposure, so
// that bays fill and open coasts keep a shelf that falls seaward. What finds no room goes on, and the last of it
// settles over the whole sea by room. Spreading is a Gaussian, not a simulated plume: it knows no currents and passes
// around headlands.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/ops/erosion/layers.h"
#include "seamount/ops/erosion/sea.h"

namespace seamount::erosion {

struct Coast {
  double years = 0;
  Sea sea;
  double retreat_m_yr = 0;   ///< retreat of a fully exposed cliff
  double wave_base_m = 8;    ///< depth to which waves move sediment
  double settling_m = 3000;  ///< deviation of the distance at which the far half of a load settles
};

/// One step. `load` holds what rivers brought to each sea cell (metres of thickness); it is spent. `room` is of the
/// ground's size. What finds no room in the sea goes to ledger.exported. Parallel; five more grids of memory.
void run_coast(Layers& ground, const Maps& site, const Coast& coast, ScalarField& load, ScalarField& room,
               Ledger& ledger, const RunContext& run);

}  // namespace seamount::erosion
