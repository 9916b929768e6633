// erosion.run: years of rain, rivers, slides and waves on a terrain of bedrock, debris and sediment.
//
// Rivers cut into the ground by their discharge and slope, carry what they cut and drop it where they slow down, so
// that drained valleys, filled valley floors and fans appear; soil creeps, and rock that stands too steep over its
// valley fails (rivers.h); bare rock weathers, and debris slides to its angle (slopes.h); waves cut the coast and
// sediment settles under water (coast.h). Rock may lie in beds, hard and soft (lithology.h). Water always finds a way
// out (drainage.h). Cf. P1 sec. 5.4, which simulates interleaved hydraulic and thermal erosion of the same three layers
// by stochastic events after Cordonnier et al. 2017; we solve for the same processes with implicit steps of many years.
//
// The run goes from coarse to fine (levels.h): it begins on a grid of about 64 cells a side and each finer grid takes a
// share of the remaining years, so that valleys of all sizes have had their time, and a small grid previews a large
// one; a run of fewer years shows the same valleys younger, so that frames of an animation are runs whose years rise.
// Land goes on beyond the border for a share of the map's side and is cut off again (margin.h), so that no rim stays
// there; if it rises, it does so up to its border. Ground below the sea's level that no sea reaches is land (sea.h).
// method stream_power leaves out what rivers carry, weathering and waves: the detachment-limited law with uplift,
// whose steady state is a mountain range (Braun and Willett 2013, Cordonnier et al. 2016).
#pragma once

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/ops/erosion/layers.h"
#include "seamount/ops/erosion/run_params.h"

namespace seamount::erosion {

struct Eroded {
  HeightField terrain;
  ScalarField debris;    ///< thickness of debris, m
  ScalarField sediment;  ///< thickness of fine sediment, m
  ScalarField flow;      ///< discharge, m3 per year, at the end
  ScalarField lake;      ///< depth of standing water on land, m
  ScalarField bed;       ///< number of the bed at the top of the bedrock, from 1; 0 where no beds were given
  Ledger ledger;
};

/// Erodes a terrain. Maps are optional (empty) and cover the same frame: hardness > 0 (hardness.h says
/// how 0 to 1 is read), mask in [0, 1] (fade.h), uplift and rain >= 0; debris and sediment are what already lies on the
/// bedrock. Zero years change nothing. The terrain loses to the border what ledger.exported says, less what came in
/// over it, and nothing else (to 1e-4 of ledger.eroded, which counts the land beyond as well; so does flow where rivers
/// come in). Throws InvalidArgument for params out of range, IncompatibleInputs for maps of another size. Parallel but
/// for the order of the rivers; about 4 us and 60 bytes per cell with the results, with beds half as much again.
Eroded run(Layers ground, Maps site, const RunParams& params, Seed seed, const RunContext& run);

}  // namespace seamount::erosion
