// JSON text to a document whose values know their place in the text. Strict: duplicate keys, deep nesting and numbers
// out of range are errors, since a recipe is written by hand as often as by a program.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "seamount/recipe/diagnostics.h"

namespace seamount::recipe {

using Json = nlohmann::json;

/// Line and column, from 1.
struct TextPlace {
  int line = 1;
  int column = 1;
};

struct JsonDocument {
  Json root;
  std::map<std::string, TextPlace> places;  ///< by JSON pointer; a member's place is its key's
};

/// Longer text is refused.
inline constexpr size_t kLargestText = size_t{64} << 20;

/// Parses `text`. Throws RecipeError naming `file` with line and column for a syntax error, a duplicate key, nesting
/// over 64 levels or text over 64 MiB. Time and memory are linear in the text.
JsonDocument parse_json(std::string_view text, const std::string& file);

/// Fills in line and column of each diagnostic and note: its own place, or that of the nearest enclosing value.
void place_diagnostics(Diagnostics& diagnostics, const JsonDocument& document);

/// A key as a part of a JSON pointer: "~" and "/" escaped.
std::string pointer_token(std::string_view key);

}  // namespace seamount::recipe
