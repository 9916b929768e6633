// One step, run here and now.
#pragma once

#include <string>

#include "seamount/recipe/recipe.h"

namespace seamount::recipe {

/// Runs a step's operator. `connected` holds the inputs that come from other steps, by port; those that come from files
/// are read. Throws what readers and operators throw, with "step 'reef' (island.coral): " before it unless the message
/// names a file.
Values run_step(const Recipe& recipe, const Step& step, Values connected, const RunContext& run);

/// The first half of it: the inputs, with those that come from files. `raster`: the frame of a raster that is connected
/// but not among `connected`; nullptr: there is none. Throws IoError.
Values read_inputs(const Recipe& recipe, const Step& step, Values connected, const GridFrame* raster,
                   const RunContext& run);

/// "step 'reef' (island.coral)", "output 'map.png' (render.map)".
std::string step_name(const Step& step);

/// Within a catch: throws it on with the step's name before the message; the kind of error stays.
[[noreturn]] void rethrow_with_step(const Step& step);

}  // namespace seamount::recipe
