// Descriptors of hydrology.describe that are curves over size: slope over drainage area, roughness over distance.
#pragma once

#include "seamount/ops/hydrology/descriptor_parts.h"

namespace seamount::hydrology {

Descriptor describe_slope_area(const Surveys& surveys);
Descriptor describe_roughness(const Surveys& surveys);

}  // namespace seamount::hydrology
