// Values as files: what an output of a recipe does, with the steps that prepare it.
#include <filesystem>

#include "errors.h"
#include "json.h"
#include "seamount/recipe/domain.h"
#include "seamount/recipe/prepare_output.h"
#include "seamount/recipe/run_outputs.h"
#include "seamount/recipe/step_work.h"
#include "values.h"
#include "work.h"

namespace seamount::python {
namespace {

using namespace recipe;
namespace fs = std::filesystem;

const char* const kPort = "value";

/// The recipe of one output, whose value and whose companions ("labels", "rivers", ...) are there.
class Saving {
 public:
  Saving(const Held& held, const std::string& path, const py::object& as, const py::dict& params,
         const py::dict& companions) {
    const fs::path place = fs::absolute(path).lexically_normal();
    folder_ = place.parent_path().string();
    recipe_.registry = &standard_registry();
    recipe_.file = "python";
    recipe_.domain = held.value.frame() != nullptr ? *held.value.frame() : domain_frame({});
    Output output;
    output.path = place.filename().string();
    output.from = add("value", held.value);
    const auto format = as.is_none() ? std::nullopt : std::optional(as.cast<std::string>());
    Diagnostics found;
    const ReadPlace top{"", found};
    const Kind& kind = held.value.kind();
    if (!choose_format(standard_registry(), kind, format, output, top)) throw_defects(found);
    output.params = output.format->complete(to_json(params, "params"), top);
    std::map<std::string, Source> drawn;
    std::optional<Source> labels;
    for (const auto& [name, value] : companions) {
      const auto key = name.cast<std::string>();
      Source source = add(key, value.cast<const Held&>().value);
      if (key == "labels")
        labels = std::move(source);
      else
        drawn[key] = std::move(source);
    }
    prepare_output(recipe_, output, kind, labels, drawn, top);
    if (!found.empty()) throw_defects(found);
    recipe_.outputs.push_back(std::move(output));
  }

  std::vector<std::string> write(const RunContext& run) {
    for (const Step& step : recipe_.steps) {
      Values connected;
      for (const auto& [port, source] : step.in) connected[port] = values_.at(source);
      for (auto& [port, value] : run_step(recipe_, step, std::move(connected), run.part(0, 0.5)))
        values_[{step.id, port, ""}] = std::move(value);
    }
    const auto reports = write_outputs(
        recipe_, folder_, [&](const Source& source) -> const Value& { return values_.at(source); },
        [&](size_t) { return run.part(0.5, 1); }, run);
    return reports.front().files;
  }

 private:
  Source add(const std::string& name, const Value& value) {
    Source source{name, kPort, ""};
    values_[source] = value;
    return source;
  }

  Recipe recipe_;
  std::string folder_;
  std::map<Source, Value> values_;
};

py::tuple save(const Held& held, const std::string& path, const py::object& as, const py::dict& params,
               const py::dict& companions, const py::object& progress) {
  Saving saving(held, path, as, params, companions);
  Work work(0, progress);
  const std::vector<std::string> files = work.run([&] { return saving.write(work.context()); });
  return py::make_tuple(to_texts(files), to_texts(work.notes()));
}

}  // namespace

void add_save(py::module_& module) { module.def("save", save); }

}  // namespace seamount::python
