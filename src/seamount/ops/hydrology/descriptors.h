// The descriptors of hydrology.describe, each from the surveys of one or two terrains.
#pragma once

#include <vector>

#include "seamount/model/report.h"
#include "seamount/ops/hydrology/survey.h"

namespace seamount::hydrology {

/// What the descriptors rest on: land, and the parameters as they were, by their names without the unit.
std::vector<Measure> make_settings(const std::vector<Survey>& surveys, const SurveyPlan& plan);

/// All of them, in the order of the page. `surveys` are of the terrain and, where there is one, the reference.
std::vector<Descriptor> make_descriptors(const std::vector<Survey>& surveys, const SurveyPlan& plan);

}  // namespace seamount::hydrology
