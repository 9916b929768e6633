// Where reading a document stands, and where what is found there goes.
#pragma once

#include <string>
#include <utility>

#include "seamount/base/error.h"
#include "seamount/recipe/diagnostics.h"
#include "seamount/recipe/json_document.h"

namespace seamount::recipe {

/// A place by its JSON pointer, with the diagnostics of the whole document.
struct ReadPlace {
  std::string pointer;
  Diagnostics& diagnostics;

  ReadPlace at(const std::string& token) const { return {pointer + "/" + token, diagnostics}; }
  ReadPlace at(size_t index) const { return at(std::to_string(index)); }
  void fail(std::string message) const { diagnostics.add(pointer, std::move(message)); }
  /// At the field below that an argument was refused for.
  void fail(const InvalidArgument& error) const {
    at(error.field()).fail(std::string(error.what()).substr(error.field().size() + 2));
  }
  void note(std::string message) const { diagnostics.note(pointer, std::move(message)); }
  /// "expected a number, found the text "abc"".
  void expected(const std::string& what, const Json& found) const;
};

}  // namespace seamount::recipe
