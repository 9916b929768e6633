// Water after an edit: where new ground dams what came in from outside, a valley is cut for it.
//
// A pond is what priority flooding fills that it did not fill before (Barnes, Lehman and Mulla 2014). From its lowest
// node the lowest way to ground that lies lower is cut as a valley whose sides are as steep as the slopes about; only
// nodes within the outline are lowered. Hollows of less than half a gap between levels are raised instead.
#pragma once

#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/ops/contour/edit/edit_area.h"

namespace seamount::contour {

/// Water that new ground holds back.
struct Pond {
  Vec2 at;  ///< its deepest place
  double depth_m;
};

/// The deepest pond that `heights` have and the area's ground had not, of at least half a gap.
std::vector<Pond> find_ponds(const EditArea& area, const ScalarField& heights, double gap_m, const RunContext& run);

/// Lets water out; returns where a valley was cut and how deep the water would have stood. What is still dammed then,
/// because ground outside would have to be cut, is what find_ponds() finds.
std::vector<Pond> let_water_out(const EditArea& area, ScalarField& heights, double gap_m, const RunContext& run);

/// Says that water is let out, or is held back.
void say_ponds(const std::string& name, const std::vector<Pond>& cut, const std::vector<Pond>& held,
               const RunContext& run);

}  // namespace seamount::contour
