#include "operators.h"

#include "errors.h"
#include "json.h"
#include "seamount/recipe/domain.h"
#include "seamount/recipe/one_frame.h"
#include "seamount/recipe/registry.h"
#include "seamount/server/schema_json.h"
#include "values.h"
#include "work.h"

namespace seamount::python {
namespace {

using recipe::Json;
using recipe::Operator;
using recipe::Values;

/// An operator of the registry, which lives as long as the program.
struct Handle {
  const Operator* op = nullptr;
};

Handle find_operator(const std::string& name) {
  const Operator* op = recipe::standard_registry().find_operator(name);
  if (op == nullptr) throw InvalidArgument("operator", "there is no '" + name + "'");
  return {op};
}

/// Keyword arguments as complete parameters; notes of former names go to `notes`.
Json params_of(const Operator& op, const py::dict& given, py::list& notes) {
  Json params = Json::object();
  for (const auto& [name, value] : given) {
    const auto key = name.cast<std::string>();
    params[key] = to_json(value, key);
  }
  recipe::Diagnostics found;
  Json complete = op.complete(params, {"", found});
  if (!found.empty()) throw_defects(found);
  for (const recipe::Diagnostic& note : found.notes()) notes.append(to_text(note.pointer + ": " + note.message));
  return complete;
}

Values inputs_of(const Operator& op, const py::dict& given) {
  Values in;
  for (const auto& [name, value] : given) in[name.cast<std::string>()] = value.cast<const Held&>().value;
  for (const recipe::Port& port : op.in) {
    const auto found = in.find(port.name);
    if (found == in.end() && port.required)
      throw InvalidArgument(port.name, "is missing; " + op.name + " needs a " + port.kind->name);
    if (found != in.end() && &found->second.kind() != port.kind)
      throw InvalidArgument(port.name, "is a " + found->second.kind().name + ", not a " + port.kind->name);
  }
  if (op.needs_one && in.empty())
    throw IncompatibleInputs(op.name + ": one of its inputs is needed, whichever; none is given");
  return in;
}

/// Runs an operator as a step of a recipe runs: its inputs brought into one frame, unknown cells filled for those that
/// do not respect them. Returns (values in the order of the outputs, lines to say).
py::tuple call(const Handle& handle, const py::dict& inputs, const py::dict& params, const py::object& domain,
               uint64_t seed, int threads, const py::object& progress) {
  static const GridFrame kDefault = recipe::domain_frame({});
  static const std::string kHere;
  const Operator& op = *handle.op;
  py::list notes;
  const Json complete = params_of(op, params, notes);
  Values in = inputs_of(op, inputs);
  const std::optional<GridFrame> stated = frame_of_any(domain);
  Work work(threads, progress);
  Values made = work.run([&] {
    const recipe::Together together =
        recipe::bring_together(op, std::move(in), stated.value_or(kDefault), work.context());
    return op.run(complete, together.in, {together.domain, stated.has_value(), Seed{seed}, kHere, work.context()});
  });
  py::tuple results(op.out.size());
  for (size_t i = 0; i < op.out.size(); ++i)
    results[i] = py::cast(Held{std::move(made.find(op.out[i].name)->second), true});
  for (const std::string& note : work.notes()) notes.append(to_text(note));
  return py::make_tuple(results, notes);
}

}  // namespace

void add_operators(py::module_& module) {
  py::class_<Handle>(module, "Operator").def("call", call);
  module.def("operator", find_operator);
  module.def("schema", [] { return from_json(server::schema_json(recipe::standard_registry())); });
}

}  // namespace seamount::python
