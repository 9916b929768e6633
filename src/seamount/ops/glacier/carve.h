// What ice does to its bed in a step: it wears it where it slides, and walls that it undercuts fall.
//
// The bed wears at right angles by abrasion times sliding (Humphrey and Raymond 1994; Braun, Zwartz and Tomkin 1999),
// over hardness, so that a steep side goes down by more. Sliding counts as the mean of the ice within `widening_m`:
// ice drags its sides along (Egholm et al. 2011 solve for it), which the shallow ice approximation leaves out, and
// which makes U of V. Rock over carved ground stands no steeper than the wall angle.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::glacier {

struct Carving {
  double years = 0;
  double abrasion = 1e-4;
  double widening_m = 150;
  double wall_angle_deg = 55;
};

/// Lowers a bed, and the ice on it with it. `start` is the ground before any ice; `hardness` may be empty. `speed` is
/// spent. Parallel but for the walls, about 60 ns per cell; one more grid of memory.
void carve(const HeightField& start, const ScalarField& hardness, const Carving& carving, ScalarField& speed,
           HeightField& bed, HeightField& surface, const RunContext& run);

}  // namespace seamount::glacier
