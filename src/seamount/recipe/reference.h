// The reference, from the registry: what `seamount describe` prints and docs/operators.md holds.
#pragma once

#include <string>

#include "seamount/recipe/registry.h"

namespace seamount::recipe {

/// One operator for a terminal.
std::string describe_operator(const Operator& op);

/// One output format for a terminal.
std::string describe_format(const OutputFormat& format);

/// One kind of value for a terminal, with the operators that take or make it.
std::string describe_kind(const Kind& kind, const Registry& registry = standard_registry());

/// docs/operators.md: every operator, output format and kind of value.
std::string reference_markdown(const Registry& registry = standard_registry());

}  // namespace seamount::recipe
