// How a step of a plan stands, from what its plan and the scheduler know of it.
#pragma once

#include "seamount/recipe/engine.h"
#include "seamount/recipe/plan.h"
#include "seamount/recipe/scheduler.h"

namespace seamount::recipe {

/// `ahead`: there is still something to be done about it; `paused`: nothing is computed. What keeps it from being
/// computed in the steps that it reads is for the caller to see.
StepState state_of(const Plan& plan, size_t index, const StepProgress& progress, bool ahead, bool paused);

}  // namespace seamount::recipe
