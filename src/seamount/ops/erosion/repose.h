// The steepest slope that bedrock can stand over years: what exceeds it fails and goes with the water.
//
// Every cell comes to lie no higher than the ground around it and the slope allow: the solution of |gradient| = slope
// above the ground that stands, by fast sweeping, so that a scarp of any height is brought down at once and slopes are
// as steep in all directions (Musgrave, Kolb and Mace 1989 bring it down by a cell at a time, which slides.h does for
// what leaves debris at its foot). Rock twice as hard stands sqrt(2) times as steep.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/ops/erosion/drainage.h"
#include "seamount/ops/erosion/layers.h"

namespace seamount::erosion {

/// Lowers `level` where its gradient is steeper than `steepest` (rise over run) times sqrt(hardness); roots of the
/// drainage stay. Four sweeps, each row both ways, which leaves little where hardness is uneven or ways bend. Masks
/// share the change out. One thread, about 15 ns per cell.
void limit_slopes(ScalarField& level, const Drainage& drainage, const Maps& site, double steepest,
                  const RunContext& run);

}  // namespace seamount::erosion
