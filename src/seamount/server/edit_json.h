// Edits and changes of a document as the studio's page sends and gets them (studio/src/api/types.ts).
#pragma once

#include <string>
#include <vector>

#include "seamount/recipe/edit.h"

namespace seamount::server {

using recipe::OrderedJson;

/// Throws InvalidArgument{"edits"} for what is no edit, with its place.
recipe::Edit read_edit(const OrderedJson& json, const std::string& place);
std::vector<recipe::Edit> read_edits(const OrderedJson& json);

/// Reads back as the same edit.
OrderedJson write_edit(const recipe::Edit& edit);

OrderedJson write_changes(const std::vector<recipe::Change>& changes);

/// Defects, or open inputs, with their places.
OrderedJson write_diagnostics(const std::vector<recipe::Diagnostic>& diagnostics);

/// JSON on one line, of text that may be no UTF-8.
std::string one_line(const OrderedJson& json);

/// What takes these changes back, in order.
std::vector<recipe::Change> inverse(const std::vector<recipe::Change>& changes);

/// Edits that make one document of another: the smallest places whose values differ.
std::vector<recipe::Edit> differences(const OrderedJson& from, const OrderedJson& to);

}  // namespace seamount::server
