// A dictionary of amplify.sparse from its file.
#pragma once

#include <string>

#include "seamount/ops/amplify/dictionary.h"

namespace seamount::recipe {

/// Throws IoError{path} for a file that cannot be read or holds something else.
amplify::Dictionary read_dictionary(const std::string& path);

}  // namespace seamount::recipe
