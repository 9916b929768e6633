// Shorthand in a document written out, so that an edit can change a part of it. Not part of the public interface.
#pragma once

#include "seamount/recipe/edit.h"

namespace seamount::recipe {

/// The step of a document with this id; nullptr: none.
const OrderedJson* find_step(const OrderedJson& root, const std::string& id);

/// The operator of a step as it is written; nullptr if it has none that is known.
const Operator* operator_of(const OrderedJson& step, const Registry& registry);

/// "in": "isle" of a step as an object of inputs; `in` itself where it is an object.
OrderedJson written_out_inputs(const OrderedJson& root, const OrderedJson& step, const Registry& registry);

/// The output that "isle" means as an output's "from" or "labels"; empty: it is not plain.
std::string written_out_port(const OrderedJson& root, const OrderedJson& output, const std::string& key,
                             const Registry& registry);

/// The output that "isle" means for an input of a step; empty: it is not plain.
std::string written_out_input_port(const OrderedJson& root, const OrderedJson& step, const std::string& input,
                                   const std::string& from, const Registry& registry);

}  // namespace seamount::recipe
