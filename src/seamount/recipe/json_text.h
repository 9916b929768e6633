// JSON as people read it: what fits on a line stays on it, so that points are pairs and strokes are lines.
#pragma once

#include <string>

#include "seamount/recipe/edit.h"

namespace seamount::recipe {

/// The value as text that ends with a line break: two blanks deep per level, a list or object on one line where that
/// takes at most 120 columns; numbers as short as they can be read back. Equal values have equal text.
std::string readable_text(const OrderedJson& value);

}  // namespace seamount::recipe
