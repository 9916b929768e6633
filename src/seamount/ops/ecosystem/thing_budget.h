// Keeps things within a number of triangles.
#pragma once

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/things.h"

namespace seamount::ecosystem {

/// Gives things coarser levels, the smallest first, and where all are at their coarsest leaves out an even share of
/// them (by lot). Says both. 0: no limit. n log n.
void keep_budget(Things& things, uint64_t max_triangles, Seed seed, const RunContext& run);

}  // namespace seamount::ecosystem
