// Removal of pits by breaching: afterwards water stays only where it is meant to.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Cells (row * width + column) within the border that none of their eight neighbours is lower than. Parallel, linear.
std::vector<int64_t> find_sinks(const HeightField& heights, const RunContext& run);

/// Changes as few heights as it can until find_sinks() finds at most those of `allowed`: from each sink a channel is
/// cut along the lowest way to lower ground or the border, falling evenly; what flat ground remains is tilted by the
/// least steps that a float can take. REQUIRES: finite heights. Linear while sinks are few; n log n for large flats.
void drain(HeightField& heights, std::span<const int64_t> allowed, const RunContext& run);

/// Cuts a channel from each of `sinks`, of find_sinks(), that lies no more than `most_m` below its way out; deeper ones
/// stay, and so does flat ground. Linear in the cells that are searched.
void drain_shallow(HeightField& heights, const std::vector<int64_t>& sinks, float most_m, const RunContext& run);

}  // namespace seamount::geom
