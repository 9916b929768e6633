// Where inputs and outputs come from, as recipes write it: "step.port", "step" alone where it is plain which of its
// outputs is meant, or a file. Not part of the public interface.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "seamount/recipe/recipe.h"

namespace seamount::recipe {

/// A step as it was written, before its operator and connections are known to be right.
struct DraftStep {
  Step step;
  ReadPlace place;
  const Json* in = nullptr;
  bool bypass = false;
};

/// A member that must be a text of printable characters; nothing after a defect, or where it is absent.
std::optional<std::string> text_member(const Json& object, const std::string& key, const ReadPlace& place,
                                       bool required);

/// What a source is for.
struct SourceUse {
  std::vector<const Kind*> kinds;  ///< those that fit; none: any
  std::string input;               ///< of an input: its name
  bool said = true;                ///< false: the recipe does not state the source, and no note explains it
};

/// Reads "step.port", "step" or {"file": name}, checks that it exists and fits.
std::optional<Source> read_source(const Json& json, const ReadPlace& place, const SourceUse& use,
                                  const std::vector<DraftStep>& drafts);

/// Connects the inputs of `draft` as its "in" says; open ones that are required go to `missing` and are why it is
/// incomplete.
void connect_inputs(DraftStep& draft, const std::vector<DraftStep>& drafts, Diagnostics& missing);

/// A required input is open.
void leave_open(Step& step, const ReadPlace& place, const std::string& why, Diagnostics& missing);

}  // namespace seamount::recipe
