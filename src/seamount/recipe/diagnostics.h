// What is wrong with a recipe: all of it at once, each with its place; and what is right but should be known.
#pragma once

#include <string>
#include <vector>

#include "seamount/base/error.h"

namespace seamount::recipe {

/// One defect, or a note. `pointer` is a JSON pointer ("/steps/1/params/subsidence"); line and column count from 1, 0
/// if unknown.
struct Diagnostic {
  std::string pointer;
  std::string message;
  int line = 0;
  int column = 0;
};

/// "kauai.json:12:5: /steps/1/op: unknown ...".
std::string diagnostic_line(const std::string& file, const Diagnostic& diagnostic);

/// Defects in the order in which they were found, and notes beside them. Empty: no defect.
class Diagnostics {
 public:
  void add(std::string pointer, std::string message) { items_.push_back({std::move(pointer), std::move(message)}); }
  void note(std::string pointer, std::string message) { notes_.push_back({std::move(pointer), std::move(message)}); }
  bool empty() const { return items_.empty(); }
  std::vector<Diagnostic>& items() { return items_; }
  const std::vector<Diagnostic>& items() const { return items_; }
  std::vector<Diagnostic>& notes() { return notes_; }
  const std::vector<Diagnostic>& notes() const { return notes_; }

 private:
  std::vector<Diagnostic> items_;
  std::vector<Diagnostic> notes_;
};

/// A document that cannot be used. what() has one line per diagnostic.
class RecipeError : public Error {
 public:
  RecipeError(const std::string& file, std::vector<Diagnostic> diagnostics);
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace seamount::recipe
