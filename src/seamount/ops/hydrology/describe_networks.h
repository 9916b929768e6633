// Descriptors of hydrology.describe that count: streams by order, ridges and rivers, peaks by prominence.
#pragma once

#include "seamount/ops/hydrology/descriptor_parts.h"

namespace seamount::hydrology {

Descriptor describe_strahler(const Surveys& surveys);
Descriptor describe_ridges(const Surveys& surveys);
Descriptor describe_prominence(const Surveys& surveys, const SurveyPlan& plan);

}  // namespace seamount::hydrology
