// hydrology.fill and hydrology.flow on rasters that do not fit into memory (drainage.h). Not: breaching, flow to
// several neighbours, sinks.
#pragma once

#include <string>

#include "seamount/tiles/world.h"

namespace seamount::tiles {

std::string fill_refusal(const recipe::Step& step, const recipe::PlannedStep& planned);
std::string flow_refusal(const recipe::Step& step, const recipe::PlannedStep& planned);

/// Throw NeedsWhole.
void run_tiled_fill(World& world, size_t step, const RunContext& run);
void run_tiled_flow(World& world, size_t step, const RunContext& run);

}  // namespace seamount::tiles
