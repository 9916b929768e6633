// Variables of a recipe: "variables": { "age": 0.3, "hero": { "azimuth_deg": 160 } }, used as "$age" wherever a
// parameter's value stands (of the domain, of a step, of an output; a number, a text, a file's name, a whole group), so
// that one number is written once and a camera is named once for several outputs. Their values may use others. A text
// that begins with a dollar is written with two.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "seamount/recipe/read_place.h"

namespace seamount::recipe {

/// The name in "$name"; nothing for any other value.
std::optional<std::string> variable_name(const Json& value);

/// A document with the values of its variables in their places. Reports unknown names, variables that need each other
/// in a circle, and values that would grow beyond 64 levels or a million; notes those that nothing uses.
class VariablesApplied {
 public:
  /// `root` and `top` must outlive it. Cost: linear in the document, which is copied if it has variables.
  VariablesApplied(const Json& root, const ReadPlace& top);

  const Json& root() const { return filled_ ? *filled_ : root_; }

  /// Says at each defect and note that was found since in what a variable stands for which one it is.
  void name_variables() const;

 private:
  struct Use {
    std::string pointer, name;
    bool failed = false;  ///< there is no value to put there
  };
  struct Resolved {
    Json value;  ///< with the values of other variables in it
    size_t size = 1;
    int depth = 0;
    bool failed = false;
  };

  void fill_document();
  void fill_members(Json& object, const std::vector<std::string>& kept, const ReadPlace& place, int depth);
  bool fill(Json& value, const ReadPlace& place, int depth);
  bool put_in(Json& value, const std::string& name, const ReadPlace& place, int depth);
  const Resolved& resolve(const std::string& name);

  const Json& root_;
  ReadPlace top_;
  size_t defects_before_ = 0, notes_before_ = 0;
  std::optional<Json> filled_;
  const Json none_ = Json::object();
  const Json* variables_ = &none_;
  std::map<std::string, Resolved> resolved_;
  std::vector<std::string> open_;  ///< variables that are being resolved, outermost first
  std::set<std::string> used_;
  std::vector<Use> uses_;
  size_t values_ = 0;  ///< that were put in
};

}  // namespace seamount::recipe
