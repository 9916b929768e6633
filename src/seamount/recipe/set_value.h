// --set: a value of a document by a path such as "steps.isle.params.relief". Not part of the public interface.
#pragma once

#include <string>

#include "seamount/recipe/registry.h"

namespace seamount::recipe {

/// Carries out "PATH=VALUE"; the value is JSON or plain text. A use of a variable on the way gets a value of its own.
/// Throws InvalidArgument{"--set"} for a path that leads nowhere, with those that were probably meant.
void set_value(Json& root, const std::string& assignment, const Registry& registry);

}  // namespace seamount::recipe
