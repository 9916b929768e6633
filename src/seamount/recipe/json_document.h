// JSON text to a document whose values know their place in the text. Strict: duplicate keys, deep nesting and numbers
// out of range are errors, since a recipe is written by hand as often as by a program.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "seamount/base/run_context.h"
#include "seamount/recipe/diagnostics.h"

namespace seamount::recipe {

using Json = nlohmann::json;

/// Its places are looked up in the text when there is something to say of them.
struct JsonDocument {
  Json root;
  std::string text;
};

/// Longer text is refused.
inline constexpr size_t kLargestText = size_t{64} << 20;

/// Parses `text`. Throws RecipeError naming `file` with line and column for a syntax error, a duplicate key, nesting
/// over 64 levels or text over 64 MiB; Cancelled. Time and memory are linear in the text.
JsonDocument parse_json(std::string_view text, const std::string& file, const RunContext& run = {});

/// Fills in line and column of each diagnostic and note: its own place, or that of the nearest enclosing value. A
/// member's place is its key's. One pass over the text, however many there are.
void place_diagnostics(Diagnostics& diagnostics, const JsonDocument& document);

/// A key as a part of a JSON pointer: "~" and "/" escaped.
std::string pointer_token(std::string_view key);

}  // namespace seamount::recipe
