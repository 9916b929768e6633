// What a file is, for people: `seamount info`.
#pragma once

#include <string>

#include "seamount/io/info.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

/// What the first kind that knows such files says of it, after its name, and the highest peaks of a terrain. Throws
/// IoError for a file that no kind knows.
io::FileInfo describe_file(const std::string& path, const Registry& registry = standard_registry());

/// The first kind that knows such files. Throws as describe_file().
const Kind& kind_of_file(const std::string& path, const Registry& registry = standard_registry());

}  // namespace seamount::recipe
