// How far the detail of a coast may go: bays and headlands take no more than a part of the land's width, so that spits,
// isthmuses and capes stay what they were drawn as.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/island/shape.h"

namespace seamount::island {

/// The most in metres that the coast may move: near it, half of the distance from the middle of the land there to its
/// coast. On a lattice of at most 512 nodes a side. For plans of areas.
ScalarField coast_room(const Plan& plan, const GridFrame& frame, const RunContext& run);

}  // namespace seamount::island
