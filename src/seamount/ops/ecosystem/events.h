// What events do to ground and water at a time (P3 sec. 1.7.2, Algorithm 4; where the text multiplies, adding is
// right).
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/scene_events.h"
#include "seamount/model/vector_field.h"

namespace seamount::ecosystem {

/// Metres that the water stands higher than at the beginning (eq. 1.56).
double water_level_change(const Timeline& timeline, double time);

/// Adds subsidence and uplift to heights. Eq. 1.57 divides by the deviation; here the change is that at the centre, in
/// metres.
void add_ground_events(const Timeline& timeline, double time, HeightField& heights, const RunContext& run);

/// Adds storms and drawn currents that blow at the time: from their start on, until before their end.
void add_event_currents(const Timeline& timeline, double time, VectorField& current, const RunContext& run);

/// Does anything change between two times?
bool changes_between(const Timeline& timeline, double from, double to);

}  // namespace seamount::ecosystem
