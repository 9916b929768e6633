// Drawn high ground rises over what lies around it: the network alone only leans that way.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/learned/sketch_planes.h"

namespace seamount::learned {

/// Moves the wide forms of `heights` (means over some cells) to their side of a level, high ground up and low ground
/// down, the more the farther they lie from the border between them; what is on its side stays, and so does all detail.
///
///   S = low_m + relief_m (0.6 - p / 2 +- 0.18 tanh(d / 14 cells)),  p the share of high ground, d the distance from
///   its border: means come to lie above about S where ground is high, below where it is low, after `adherence` of the
///   way.
///
/// Nothing where no level is drawn. Parallel, linear; 24 bytes per cell.
void meet_level(const SketchMap& map, double adherence, HeightField& heights, const RunContext& run);

}  // namespace seamount::learned
