// The reference, from the registry: what `seamount describe` prints and docs/operators.md holds.
#pragma once

#include <string>

#include "seamount/recipe/outputs.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

/// One operator for a terminal.
std::string describe_operator(const Operator& op);

/// One output format for a terminal.
std::string describe_format(const OutputFormat& format);

/// docs/operators.md: every operator and output format.
std::string reference_markdown();

}  // namespace seamount::recipe
