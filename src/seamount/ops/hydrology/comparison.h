// What hydrology.describe settles before it surveys: one cell size for both terrains, and the thresholds they share.
#pragma once

#include <optional>
#include <vector>

#include "seamount/model/grid.h"
#include "seamount/ops/hydrology/survey.h"

namespace seamount::hydrology {

/// Cell size at which terrains are compared: the wanted, or the coarsest of their own. Throws InvalidArgument{cell_m}
/// where the wanted is finer, since cells would be described that nobody measured.
double comparison_cell(const std::vector<GridFrame>& frames, std::optional<double> wanted_m);

/// The frame on cells of that size. Throws InvalidArgument{cell_m} where it has more cells than can be numbered.
GridFrame frame_at(const GridFrame& frame, double cell_m);

/// Fills in what was not asked for: a channel begins with a 2000th of the smaller land's area, a peak has a 50th of the
/// relief of the reference's land; of all the terrain and of the other where there is no land. REQUIRES: the land of
/// the terrain and, where there is one, of the reference.
SurveyPlan make_plan(const std::vector<Land>& lands, float sea_level_m, double relief_window_m,
                     std::optional<double> channel_m2, std::optional<double> min_prominence_m);

}  // namespace seamount::hydrology
