// The radial strokes of P0 fig. 1.38.
#pragma once

#include <vector>

#include "seamount/base/rng.h"
#include "seamount/model/drawn.h"

namespace seamount::island {

/// Radial strokes from the centre to `reach_m`, at about equal angles, landward and seaward in turn; width and strength
/// vary by a third.
std::vector<Stroke> radial_strokes(int count, double width_m, double strength_m, Vec2 centre, double reach_m,
                                   Seed seed);

}  // namespace seamount::island
