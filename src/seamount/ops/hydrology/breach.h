// Least-cost breaching (Lindsay and Dhun 2015): trenches from pits to lower ground.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

/// Cuts a trench from every pit, from the lowest on, to the first place that lies below the pit, at sea or on the
/// border, along the way on which the sum of cuts is least; of equal ones the shortest, then the one found first. A pit
/// whose trench would be longer than max_steps cells or deeper than max_cut_m somewhere stays. The trench has the pit's
/// height.
///
/// Dijkstra's search from one pit after the other, on one thread: about the cells that are cheaper to reach than the
/// way out, some 0.1 us each. 5 bytes per cell, and 24 per cell that the widest search reaches.
void breach_depressions(HeightField& terrain, float sea_level_m, int max_steps, float max_cut_m, const RunContext& run);

}  // namespace seamount::hydrology
