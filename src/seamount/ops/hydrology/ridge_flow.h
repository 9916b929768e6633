// The flow of the inverted terrain: where ways up lead, and how much ground each of them serves.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

struct RidgeFlow {
  geom::FlowDirections directions;  ///< steepest ascent; over passes to higher summits; kPit on the highest
  ScalarField cells;                ///< of land whose ways up pass through a cell
  Grid<uint8_t> land;               ///< 1 above sea level
};

/// Parallel as geom::flow_directions(); 20 bytes per cell.
RidgeFlow ridge_flow(const HeightField& terrain, float sea_level_m, const RunContext& run);

}  // namespace seamount::hydrology
