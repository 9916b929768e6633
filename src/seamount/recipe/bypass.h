// What a bypassed step passes on: which of its inputs stands in for an output.
#pragma once

#include "seamount/recipe/recipe.h"

namespace seamount::recipe {

/// The input that an output of a bypassed step is taken from: the one of the same name and kind; else, for the first
/// output of its kind, the first input of that kind. nullptr: the operator has none. REQUIRES: `out` is a port of op.
const Port* stand_in(const Operator& op, const Port& out);

/// Where a source really comes from: itself, or what its step passes on if that is one of `bypassed` (whose own inputs
/// have been followed). Nothing: no input stands in for it, or that one is open.
std::optional<Source> follow(const std::vector<Step>& bypassed, const Source& source);

/// Why follow() gives nothing: "'coat.labels' is bypassed, and its input 'labels' is open".
std::string why_nothing(const std::vector<Step>& bypassed, const Source& source);

}  // namespace seamount::recipe
