// What rivers, failing slopes and standing water make of a terrain in some years, in a few passes.
//
// As erosion.run does it (ops/erosion/run.h), which takes a hundred times as long: from a coarse grid of about 64 cells
// a side to finer ones, each of which takes a share of the years, so that valleys of all sizes have their time. On each
// grid water finds its ways once, drawn so that it follows the slope and not the grid (geom/water/facet.h), rivers cut
// along them in one implicit step (geom/water/incise.h), what is too steep fails, and what they carry settles in lakes
// and the sea (geom/water/settle.h). Creep, fans and ways that shift are left out.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/incise.h"
#include "seamount/model/grid.h"

namespace seamount::learned {

struct ErosionEstimate {
  HeightField worn;    ///< what the coarser grids made of the ground
  HeightField filled;  ///< the water's level on that
  geom::FlowDirections directions;
  Grid<uint32_t> cells;
  geom::Incised made;  ///< from `worn`
};

/// years > 0. Deterministic. Partly in parallel; linear; 0.3 us and 60 bytes per cell.
ErosionEstimate estimate_erosion(const HeightField& ground, double years, double sea_m, const RunContext& run);

}  // namespace seamount::learned
