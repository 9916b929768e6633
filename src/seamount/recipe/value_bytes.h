// Values as bytes, for the cache: exact, checksummed, in the machine's own byte order.
#pragma once

#include <iosfwd>
#include <optional>

#include "seamount/recipe/registry.h"

namespace seamount::recipe {

void write_values(std::ostream& out, const Values& values);

/// What write_values wrote, or nothing if the bytes are damaged, truncated, of another version or of a kind that the
/// registry does not know.
std::optional<Values> read_values(std::istream& in, const Registry& registry);

}  // namespace seamount::recipe
