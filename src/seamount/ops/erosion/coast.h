// The coast: waves cut cliffs back and shoals down, and what rivers and waves bring settles on the sea floor.
//
// Cliff retreat: waves move the shore inland at a rate in metres per year that grows with its exposure (the share of
// open sea around it, a proxy of fetch) and falls with hardness; what stands there goes into the water (Sunamura 1992).
// Below water, waves plane the floor down to their base. Loads spread over the sea around where they enter it, half of
// them near, half far, and settle less where waves stir the water; what finds no room below sea level goes on, and the
// last of it settles over the whole sea by depth. Spreading is a Gaussian, not a simulated plume: it knows no currents
// and passes around headlands.
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
/// ground's size. What finds no room in the sea goes to ledger.exported. Parallel; two more grids of memory.
void run_coast(Layers& ground, const Maps& site, const Coast& coast, ScalarField& load, ScalarField& room,
               Ledger& ledger, const RunContext& run);

}  // namespace seamount::erosion
