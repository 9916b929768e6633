// glacier.run: valleys of ice. Snow over the equilibrium line becomes ice, which flows down (ice.h), melts, and on its
// way carves (carve.h): valleys with wide floors and steep walls, cirques at their heads, basins in their floors.
//
// The run goes from coarse to fine: it begins on a grid of about 64 cells a side, and each finer grid takes a share of
// the remaining years, so that ice finds its way over long distances in few sweeps, and a small grid previews a large
// one. Between two steps of carving, of some thousand years, ice comes near its steady state, as glaciers do within
// centuries. What is carved leaves the map with the meltwater: there are no moraines. Detail that a coarse grid could
// not hold is ground off by the depth of what was carved.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/glacier/run_params.h"

namespace seamount::glacier {

struct Carved {
  HeightField terrain;  ///< ground, when the ice has gone
  HeightField surface;  ///< ground and ice at the end of the years
  ScalarField ice;      ///< thickness of the ice then, m
  ScalarField worn;     ///< depth of what was carved: the terrain before less the one after, m
};

/// `hardness` (> 0, how many times as hard as params.abrasion says) may be empty. Throws InvalidArgument for params
/// out of range, IncompatibleInputs for a map of another size. Nothing random. Parallel; about 4 us per cell.
Carved run(const HeightField& terrain, ScalarField hardness, const RunParams& params, const RunContext& run);

}  // namespace seamount::glacier
