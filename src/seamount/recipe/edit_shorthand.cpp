#include "seamount/recipe/edit_shorthand.h"

#include "seamount/recipe/kinds.h"
#include "seamount/recipe/shorthand.h"

namespace seamount::recipe {
namespace {

const Operator* operator_by_id(const OrderedJson& root, const std::string& id, const Registry& registry) {
  const OrderedJson* step = find_step(root, id);
  return step == nullptr ? nullptr : operator_of(*step, registry);
}

std::string name_of(const Port* port) { return port == nullptr ? "" : port->name; }

/// "in": ["reef_1", "reef_2"], a row of inputs each.
OrderedJson written_out_rows(const OrderedJson& root, const OrderedJson& step, const OrderedJson& in,
                             const Registry& registry) {
  OrderedJson inputs = OrderedJson::object();
  const Operator* consumer = operator_of(step, registry);
  for (size_t i = 0; consumer != nullptr && i < in.size(); ++i) {
    if (!in[i].is_string()) continue;
    const auto text = in[i].get<std::string>();
    const Operator* producer = operator_by_id(root, text, registry);
    if (producer == nullptr) continue;
    for (const auto& [input, output] : row_connections(*consumer, *producer, static_cast<int>(i)))
      inputs[input->name] = text + "." + output->name;
  }
  return inputs;
}

}  // namespace

const OrderedJson* find_step(const OrderedJson& root, const std::string& id) {
  const auto steps = root.find("steps");
  for (size_t i = 0; steps != root.end() && i < steps->size(); ++i) {
    if ((*steps)[i].is_object() && (*steps)[i].value("id", OrderedJson()) == id) return &(*steps)[i];
  }
  return nullptr;
}

const Operator* operator_of(const OrderedJson& step, const Registry& registry) {
  const auto op = step.find("op");
  return op == step.end() || !op->is_string() ? nullptr : registry.find_operator(op->get<std::string>());
}

OrderedJson written_out_inputs(const OrderedJson& root, const OrderedJson& step, const Registry& registry) {
  const OrderedJson in = step.value("in", OrderedJson::object());
  if (in.is_array()) return written_out_rows(root, step, in, registry);
  if (!in.is_string()) return in;
  const auto text = in.get<std::string>();
  const size_t dot = text.find('.');
  const Operator* consumer = operator_of(step, registry);
  const Operator* producer = operator_by_id(root, text.substr(0, dot), registry);
  OrderedJson inputs = OrderedJson::object();
  if (consumer == nullptr || producer == nullptr) return inputs;
  if (dot == std::string::npos) {
    for (const auto& [input, output] : meant_connections(*consumer, *producer))
      inputs[input->name] = text + "." + output->name;
  } else if (const Port* output = producer->find_out(text.substr(dot + 1)); output != nullptr) {
    if (const Port* input = meant_input(*consumer, *output)) inputs[input->name] = text;
  }
  return inputs;
}

std::string written_out_port(const OrderedJson& root, const OrderedJson& output, const std::string& key,
                             const Registry& registry) {
  const Operator* producer = operator_by_id(root, output.at(key).get<std::string>(), registry);
  if (producer == nullptr) return "";
  if (key == "labels") return name_of(meant_output(*producer, key, {&kinds::Labels::kind()}));
  if (key == "rivers") return name_of(meant_output(*producer, key, {&kinds::Drawing::kind()}));
  if (key == "lake") return name_of(meant_output(*producer, key, {&kinds::Field::kind()}));
  const OrderedJson path = output.value("path", OrderedJson("")), as = output.value("as", OrderedJson());
  const auto named = as.is_string() ? std::optional(as.get<std::string>()) : std::nullopt;
  return name_of(
      meant_written(*producer, written_kinds(registry, path.is_string() ? path.get<std::string>() : "", named)));
}

std::string written_out_input_port(const OrderedJson& root, const OrderedJson& step, const std::string& input,
                                   const std::string& from, const Registry& registry) {
  const Operator* consumer = operator_of(step, registry);
  const Operator* producer = operator_by_id(root, from, registry);
  const Port* port = consumer == nullptr ? nullptr : consumer->find_in(input);
  return port == nullptr || producer == nullptr ? "" : name_of(meant_output(*producer, input, {port->kind}));
}

}  // namespace seamount::recipe
