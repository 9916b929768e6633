// What "step" alone means where "step.port" could stand.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "seamount/recipe/registry.h"

namespace seamount::recipe {

/// The output that is meant for an input of this name: that of the same name if it is of one of `kinds` (none: any),
/// else the only one that is; nullptr where it is not plain.
const Port* meant_output(const Operator& producer, const std::string& input, const std::vector<const Kind*>& kinds);

/// Pairs of an input and an output that "in": "step" connects: those that have the same name and kind.
std::vector<std::pair<const Port*, const Port*>> meant_connections(const Operator& consumer, const Operator& producer);

/// The input that "in": "step.port" is meant for: that of the same name and kind, else the only one of its kind, or the
/// only required one; nullptr where it is not plain.
const Port* meant_input(const Operator& consumer, const Port& output);

/// Kinds that can be written to `path` as `as`, or as its extension says: for an output's "from": "step".
std::vector<const Kind*> written_kinds(const Registry& registry, const std::string& path,
                                       const std::optional<std::string>& as);

}  // namespace seamount::recipe
