// The steepest slope that bedrock can stand over years: what exceeds it fails and goes with the water.
//
// Every cell comes to lie no higher than the ground around it and the slope allow: the solution of |gradient| = slope
// above the ground that stands, by fast sweeping, so that a scarp of any height is brought down at once and slopes are
// as steep in all directions (Musgrave, Kolb and Mace 1989 bring it down by a cell at a time, which slides.h does for
// what leaves debris at its foot). Rock twice as hard stands sqrt(2) times as steep.
// Where faces of one steepness meet, crests are straight and lie as the grid does; so rock is uneven.
#pragma once

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/ops/erosion/drainage.h"
#include "seamount/ops/erosion/layers.h"

namespace seamount::erosion {

/// What rock of hardness 1 can stand.
struct Strength {
  double steepest = 1e9;    ///< rise over run
  double variation = 0;     ///< of hardness, 0 to 0.95: joints make faces uneven, steeper here and gentler there
  double hollow_m3_yr = 1;  ///< water from which on hollows are gentler
  Seed seed;
};

/// The steepest rise over a cell in metres: that of `strength`, times sqrt(hardness), by joints, and less in hollows,
/// where debris and water cut gullies: faces of one slope would meet in straight crests. Parallel, 20 ns per cell.
void find_steepest_rise(const ScalarField& discharge, const Maps& site, const Strength& strength, ScalarField& rise,
                        const RunContext& run);

/// Lowers `level` where its gradient is steeper than `rise` over a cell; roots of the drainage stay. Four sweeps, each
/// row both ways, which leaves little where hardness is uneven or ways bend. Masks share the change out. One thread,
/// about 15 ns per cell.
void limit_slopes(ScalarField& level, const Drainage& drainage, const Maps& site, const ScalarField& rise,
                  const RunContext& run);

}  // namespace seamount::erosion
