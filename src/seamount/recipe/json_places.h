// Where the values of a JSON text stand in it. Not part of the public interface.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "seamount/recipe/diagnostics.h"

namespace seamount::recipe {

/// Line and column, from 1.
struct TextPlace {
  int line = 1;
  int column = 1;
};

TextPlace place_of(std::string_view text, size_t offset);

/// The places of some pointers in valid JSON text: of each the nearest enclosing value that is there. A member's place
/// is its key's. One pass over the text.
std::map<std::string, TextPlace> find_places(std::string_view text, const std::vector<std::string>& pointers);

/// Keys that an object of valid JSON text has twice, each with the place of the second one.
std::vector<Diagnostic> find_duplicate_keys(std::string_view text);

}  // namespace seamount::recipe
