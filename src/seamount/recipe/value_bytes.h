// Values as bytes, for the cache: exact, checksummed, in the machine's own byte order.
#pragma once

#include <iosfwd>
#include <optional>

#include "seamount/recipe/value.h"

namespace seamount::recipe {

void write_values(std::ostream& out, const Values& values);

/// What write_values wrote, or nothing if the bytes are damaged, truncated or of another version.
std::optional<Values> read_values(std::istream& in);

}  // namespace seamount::recipe
