// The current of a scene: what terrain, people, events and objects make of it (P3 eq. 1.50-1.55).
#pragma once

#include "seamount/ops/ecosystem/environment.h"

namespace seamount::ecosystem {

/// m/s at a time over `height` (metres over the water level), whose frame it gets. Where `around` is the current of a
/// coarser frame, it is what that says, and what the objects of the window add to it. Parallel.
VectorField current_of(const Scene& scene, const Site& site, const ScalarField& height, int window, double time,
                       const VectorField* around, const RunContext& run);

}  // namespace seamount::ecosystem
