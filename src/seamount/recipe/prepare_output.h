// What an output of a recipe is written as, and what must be made first. Not part of the public interface.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "seamount/recipe/recipe.h"

namespace seamount::recipe {

/// What a format writes to, for messages: ".tif, .png", or "a folder" where no extension is wanted.
std::string written_to(const OutputFormat& format);

/// Chooses the format of output.path for a value of this kind: the one named by `as`, or by the extension. Reports what
/// is wrong at `place` and returns false then.
bool choose_format(const Registry& registry, const Kind& kind, const std::optional<std::string>& as, Output& output,
                   const ReadPlace& place);

/// The id of the step that does what `step` does: one that is there already, or `step`, added.
std::string add_once(std::vector<Step>& steps, Step step);

/// Fills in output.files, and adds the steps that make of the value what is written, unless the recipe has some already
/// that make the same; output.from and output.prepared are then theirs. `labels` go with a terrain, `drawn` to
/// the inputs of these names. REQUIRES: format,
/// params and from are known.
void prepare_output(Recipe& recipe, Output& output, const Kind& kind, const std::optional<Source>& labels,
                    const std::map<std::string, Source>& drawn, const ReadPlace& place);

}  // namespace seamount::recipe
