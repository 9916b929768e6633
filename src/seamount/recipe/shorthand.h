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

/// The output that is meant by "from": "step" of what is written as one of `kinds`: the only one, or of several the
/// operator's first if it is one of them; nullptr where it is not plain.
const Port* meant_written(const Operator& producer, const std::vector<const Kind*>& kinds);

/// Pairs of an input and an output that "in": "step" connects: those that have the same name and kind.
std::vector<std::pair<const Port*, const Port*>> meant_connections(const Operator& consumer, const Operator& producer);

/// A row of inputs that operators with several alike have: "terrain_2", "labels_2", "field_2" for the second.
/// `count`: of the rows that there are; 0: the operator has none.
int count_rows(const Operator& consumer);

/// As meant_connections, to the inputs of one row, from 0 on.
std::vector<std::pair<const Port*, const Port*>> row_connections(const Operator& consumer, const Operator& producer,
                                                                 int row);

/// The input that "in": "step.port" is meant for: that of the same name and kind, else the only one of its kind, or the
/// only required one; nullptr where it is not plain.
const Port* meant_input(const Operator& consumer, const Port& output);

/// Kinds that can be written to `path` as `as`, or as its extension says: for an output's "from": "step".
std::vector<const Kind*> written_kinds(const Registry& registry, const std::string& path,
                                       const std::optional<std::string>& as);

/// Formats that write a value of this kind to `path` if "as" names them, and are chosen by no extension.
std::vector<std::string> ways_by_name(const Registry& registry, const std::string& path, const Kind& kind);

/// Kinds that can be written to `path`, which says nothing of itself, if "as" says how.
std::vector<const Kind*> kinds_by_name(const Registry& registry, const std::string& path);

}  // namespace seamount::recipe
