// One step, run here and now.
#pragma once

#include "seamount/recipe/recipe.h"

namespace seamount::recipe {

/// Runs a step's operator. `connected` holds the inputs that come from other steps, by port; those that come from files
/// are read. Throws what readers and operators throw, with "step 'reef' (island.coral): " before it unless the message
/// names a file.
Values run_step(const Recipe& recipe, const Step& step, Values connected, const RunContext& run);

}  // namespace seamount::recipe
