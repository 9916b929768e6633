// The ground of a scene with what its objects and events make of it (P3 eq. 1.46-1.49, 1.57).
#pragma once

#include "seamount/ops/ecosystem/environment.h"

namespace seamount::ecosystem {

/// Metres over z = 0 at a time, on the scene's frame or that of a window, whose ground is the site's, interpolated.
/// Objects that are smaller than a cell of the frame are left out. Parallel.
HeightField ground_with_objects(const Scene& scene, const Site& site, int window, double time, double water_level_m,
                                const RunContext& run);

}  // namespace seamount::ecosystem
