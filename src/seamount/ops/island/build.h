// island.build: from the plan and the profile of an island to its height field and label map.
//
// Source: P0 sec. 1.4.1, eq. 1.1 and 1.2, Algorithm 1 part 1, and the low-amplitude noise of its last paragraph.
// Departures: plans of any form (coordinate.h); a summit for every lobe of the land, or those that are given
// (summits.h), each exactly as high as it was asked for when everything else is done (peak_heights.h): what other
// operators do later - wind, subsidence, erosion - may move and lower it; heights in metres; irregular detail of random
// coasts; gullies that run down the slopes (geom/water/gullies.h), and what pits remain is breached, so that all land
// drains to the sea.
#pragma once

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"
#include "seamount/ops/island/build_params.h"
#include "seamount/ops/island/shape.h"

namespace seamount::island {

struct Island {
  HeightField terrain;
  LabelMap labels;
  ScalarField coordinate;  ///< x~ in [0, 5]
};

/// Heights over x~ in metres for a summit of this height: params.profile with its land scaled to it, or the shape of an
/// old volcanic island.
Curve profile_curve(const Plan& plan, const BuildParams& params, double peak_m);

/// Builds the island of a plan on a frame. `params` gives everything but the plan: its coast, outlines, areas and
/// widths have gone into the plan and are not looked at again. Throws InvalidArgument for params out of range, a
/// profile whose knots do not ascend, and a coast that touches the frame's edge. Parallel; about 13 bytes per cell with
/// the result, and lattices of at most 2048 x 2048.
Island build(const Plan& plan, const BuildParams& params, const GridFrame& frame, Seed seed, const RunContext& run);

}  // namespace seamount::island
