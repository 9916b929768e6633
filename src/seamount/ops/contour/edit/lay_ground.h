// New ground laid into an area: fitted to the heights along its outline and blended with what was there.
#pragma once

#include <string>

#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/contour_set.h"
#include "seamount/ops/contour/edit/edit_area.h"

namespace seamount::contour {

/// Share of the way from the outline to the area's middle over which grounds blend unless that is said.
constexpr double kSoftRim = 0.4;

/// Heights of a pattern (pattern.h) on a lattice around its outline, in its own places.
ScalarField pattern_ground(const Drawing& pattern, const RunContext& run);

/// How far the innermost place lies from the outline.
double half_width(const EditArea& area);

/// `laid` and a membrane over what it lacks at the outline (Perez, Gangnet and Blake 2003), blended over `blend_m` with
/// the area's ground; at the outline both ground and slope are the area's.
ScalarField lay_ground(const EditArea& area, const ScalarField& laid, double raise_m, double blend_m,
                       const RunContext& run);

/// Ground that bends as little as can be over the outline and goes on from outside with the same slope.
ScalarField close_ground(const EditArea& area, const RunContext& run);

/// Replaces the contours in the area by those of the heights, at as many levels as those reach. Throws as
/// levels_covering() and replace_patch() do.
void replace_area(ContourSet& set, const EditArea& area, const ScalarField& heights, const std::string& name,
                  const RunContext& run);

}  // namespace seamount::contour
