#include "recipes.h"

#include <pybind11/stl.h>

#include <array>
#include <memory>

#include "errors.h"
#include "json.h"
#include "seamount/recipe/engine.h"
#include "seamount/server/edit_json.h"
#include "values.h"
#include "work.h"

namespace seamount::python {
namespace {

using recipe::Document;
using recipe::Engine;
using recipe::Source;

constexpr int kPollMilliseconds = 20;
constexpr std::array<const char*, 8> kStandings = {"fresh",  "stale",   "queued",     "running",
                                                   "failed", "blocked", "incomplete", "bypassed"};

/// A recipe's document with the engine under it. Nothing is computed unless somebody waits for it.
class Recipe {
 public:
  Recipe(const std::string& text, const std::string& file, const std::string& folder, int threads,
         const std::optional<std::string>& cache, uint64_t memory_bytes, int coarse_cells) {
    recipe::EngineOptions options;
    options.threads = threads;
    if (cache) options.cache_folder = *cache;
    options.memory_bytes = memory_bytes;
    options.coarse_cells = coarse_cells;
    const py::gil_scoped_release released;
    engine_ = std::make_unique<Engine>(Document(text, file, folder), options);
  }
  ~Recipe() {
    const py::gil_scoped_release released;  // what runs is stopped and waited for
    engine_.reset();
  }
  Recipe(const Recipe&) = delete;
  Recipe& operator=(const Recipe&) = delete;

  bool edit(const py::object& edits, const std::string& gesture, const std::string& label) {
    const auto read = server::read_edits(to_ordered_json(edits, "edits"));
    const py::gil_scoped_release released;
    return !engine_->edit(read, gesture, label, "python").empty();
  }

  bool undo() {
    const py::gil_scoped_release released;
    return engine_->undo();
  }
  bool redo() {
    const py::gil_scoped_release released;
    return engine_->redo();
  }
  void refresh() {
    const py::gil_scoped_release released;
    engine_->refresh();
  }

  template <class T>
  T of_document(T (*tell)(const Document&)) const {
    std::optional<T> told;
    engine_->look([&](const Document& document) { told = tell(document); });
    return *told;
  }
  void save(const std::string& path) const {
    const py::gil_scoped_release released;
    engine_->look([&](const Document& document) { document.moved_to(path).save(path); });
  }
  uint64_t revision() const { return engine_->revision(); }
  uint64_t bytes() const { return engine_->bytes_in_memory(); }

  /// How each step stands.
  py::list steps() {
    recipe::EngineState state;
    {
      const py::gil_scoped_release released;
      do engine_->wait_for(kPollMilliseconds);  // for the plan, not for what another thread waits for
      while ((state = engine_->state()).revision != engine_->revision());
    }
    py::list rows;
    for (const recipe::StepState& step : state.steps) {
      py::dict row;
      row["id"] = to_text(step.id);
      row["op"] = step.op;
      row["standing"] = kStandings[static_cast<size_t>(step.standing)];
      row["seconds"] = step.seconds;
      row["cached"] = step.cached;
      row["message"] = to_text(step.message);
      row["notes"] = to_texts(step.notes);
      rows.append(row);
    }
    return rows;
  }

  /// Values of "step.port", computed where they are out of date: (values, lines to say).
  py::tuple values(const std::vector<std::pair<std::string, std::string>>& wanted, bool coarse,
                   const py::object& progress);

  /// Writes the outputs: (what was written, steps, lines to say).
  py::tuple run(const std::string& folder, const py::object& progress);

 private:
  void wait(const py::object& progress);
  void throw_failure(const Source& source) const;

  std::unique_ptr<Engine> engine_;
};

/// Wants nothing any more, however it ends.
class Wanting {
 public:
  Wanting(Engine& engine, const std::vector<Source>& sources, recipe::Quality quality) : engine_(engine) {
    const py::gil_scoped_release released;
    engine_.want(sources, quality);
  }
  ~Wanting() {
    const py::gil_scoped_release released;
    engine_.want({}, recipe::Quality::full);
  }
  Wanting(const Wanting&) = delete;
  Wanting& operator=(const Wanting&) = delete;

 private:
  Engine& engine_;
};

void Recipe::wait(const py::object& progress) {
  constexpr double kStep = 0.01;
  double told = -1.0;
  for (bool settled = false; !settled;) {
    double fraction = 0;
    {
      const py::gil_scoped_release released;
      settled = engine_->wait_for(kPollMilliseconds);
      if (!progress.is_none()) fraction = settled ? 1.0 : engine_->state().fraction;
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (progress.is_none() || (fraction < told + kStep && !settled)) continue;
    told = fraction;
    progress(fraction);
  }
}

/// The reason for which there is no result.
void Recipe::throw_failure(const Source& source) const {
  const recipe::EngineState state = engine_->state();
  for (const recipe::StepState& step : state.steps) {
    if (step.id != source.step || step.message.empty()) continue;
    if (step.standing == recipe::Standing::incomplete)
      throw InvalidArgument(step.id, "cannot run yet: " + step.message);
    throw Error(step.message);
  }
  throw InvalidArgument(source.step + "." + source.port, "is no result of this recipe");
}

py::tuple Recipe::values(const std::vector<std::pair<std::string, std::string>>& wanted, bool coarse,
                         const py::object& progress) {
  std::vector<Source> sources;
  for (const auto& [step, port] : wanted) sources.push_back({step, port, ""});
  const Wanting wanting(*engine_, sources, coarse ? recipe::Quality::coarse : recipe::Quality::full);
  const uint64_t revision = engine_->revision();
  wait(progress);
  py::list values, notes;
  for (const Source& source : sources) {
    const auto found = engine_->value(source);
    if (!found || found->revision < revision) throw_failure(source);
    values.append(py::cast(Held{found->value, false}));
  }
  for (const recipe::StepState& step : engine_->state().steps)
    for (const std::string& note : step.notes) notes.append(to_text("step '" + step.id + "': " + note));
  return py::make_tuple(values, notes);
}

py::tuple Recipe::run(const std::string& folder, const py::object& progress) {
  Work work(0, progress);
  const recipe::ExecuteReport report = work.run([&] { return engine_->write_outputs(folder, work.context()); });
  py::list outputs, steps, notes;
  for (const recipe::OutputReport& output : report.outputs) {
    py::dict row;
    row["path"] = to_text(output.path);
    row["format"] = output.format;
    row["seconds"] = output.seconds;
    row["files"] = to_texts(output.files);
    row["notes"] = to_texts(output.notes);
    outputs.append(row);
  }
  for (const recipe::StepReport& step : report.steps) {
    py::dict row;
    row["id"] = to_text(step.id);
    row["op"] = step.op;
    row["seconds"] = step.seconds;
    row["cached"] = step.cached;
    row["notes"] = to_texts(step.notes);
    steps.append(row);
    for (const std::string& note : step.notes) notes.append(to_text("step '" + step.id + "': " + note));
  }
  for (const std::string& note : work.notes()) notes.append(to_text(note));
  return py::make_tuple(outputs, steps, notes);
}

}  // namespace

void add_recipes(py::module_& module) {
  py::class_<Recipe>(module, "Recipe")
      .def(py::init<const std::string&, const std::string&, const std::string&, int, const std::optional<std::string>&,
                    uint64_t, int>())
      .def("edit", &Recipe::edit)
      .def("undo", &Recipe::undo)
      .def("redo", &Recipe::redo)
      .def("refresh", &Recipe::refresh)
      .def("steps", &Recipe::steps)
      .def("values", &Recipe::values)
      .def("run", &Recipe::run)
      .def("revision", &Recipe::revision)
      .def("bytes", &Recipe::bytes)
      .def("text",
           [](const Recipe& recipe) {
             return to_text(recipe.of_document<std::string>([](const Document& document) { return document.text(); }));
           })
      .def("json",
           [](const Recipe& recipe) {
             return from_json(
                 recipe.of_document<recipe::OrderedJson>([](const Document& document) { return document.json(); }));
           })
      .def("domain",
           [](const Recipe& recipe) {
             return frame_tuple(
                 recipe.of_document<GridFrame>([](const Document& document) { return document.recipe().domain; }));
           })
      .def("missing",
           [](const Recipe& recipe) {
             py::list lines;
             for (const auto& one : recipe.of_document<std::vector<recipe::Diagnostic>>(
                      [](const Document& document) { return document.missing(); }))
               lines.append(to_text(one.pointer + ": " + one.message));
             return lines;
           })
      .def("save", [](const Recipe& recipe, const std::string& path) { recipe.save(path); });
}

}  // namespace seamount::python
