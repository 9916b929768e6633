// Rain that finds its own way: the stochastic D8 of P1 sec. 5.1.
#pragma once

#include <cstdint>
#include <optional>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"
#include "seamount/model/grid.h"

namespace seamount::sketch {

struct StochasticFlow {
  double leave = 0.2;      ///< probability with which a drop leaves a local minimum instead of disappearing
  float shallow_m = 2.0F;  ///< minima that are not deeper hold no water: every drop leaves them
  int drops = 1;           ///< per cell
};

/// How water leaves a pit.
struct WayOut {
  int64_t end;    ///< the first cell on its way that is lower than the pit, or where flow ends
  float depth_m;  ///< of the pit below the highest place on the way
};

/// Along `routes`, in which route_through_pits() has turned the way from pit to pass round; nothing where no way leads
/// to lower ground or an outlet.
std::optional<WayOut> way_out(const HeightField& surface, const geom::FlowDirections& routes, int64_t pit);

struct Water {
  Grid<uint32_t> passed;  ///< drops that came through a cell, its own included
  Grid<uint32_t> ended;   ///< drops that disappeared in it, which must be a local minimum
};

/// Drops start on every cell with starts != 0 and step to a lower neighbour, chosen with a probability in proportion to
/// the height difference, until they leave the map, reach the sea, or disappear in a minimum. Leaving one means to go
/// on over its lowest pass below highest_pass_m, to the first place that is lower; on level ground drops go the way of
/// D8. `starts` has the surface's size. Parallel over drops, each with numbers of its own; 45 bytes per cell.
Water stochastic_flow(const HeightField& surface, const Grid<uint8_t>& starts, float sea_level_m, float highest_pass_m,
                      const StochasticFlow& params, Seed seed, const RunContext& run);

}  // namespace seamount::sketch
