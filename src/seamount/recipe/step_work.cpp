#include "seamount/recipe/step_work.h"

#include <fmt/format.h>

#include "seamount/recipe/kinds.h"
#include "seamount/recipe/one_frame.h"
#include "seamount/recipe/plan.h"

namespace seamount::recipe {
namespace {

Value read_file(const Port& port, const std::string& path, const GridFrame& frame, bool joins, const RunContext& run) {
  run.check_cancelled();
  if (!port.kind->read_file) throw IoError(path, "a " + port.kind->name + " is written, never read");
  return {*port.kind, port.kind->read_file({path, frame, joins, run})};
}

}  // namespace

std::string step_name(const Step& step) {
  return step.output.empty() ? fmt::format("step '{}' ({})", step.id, step.op->name)
                             : fmt::format("output '{}' ({})", step.output, step.op->name);
}

[[noreturn]] void rethrow_with_step(const Step& step) {
  const std::string name = step_name(step);
  try {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const IoError&) {
    throw;  // it names its file
  } catch (const RecipeError&) {
    throw;  // of a file that a step reads: it names that, and each defect with its line
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(name, error.what());
  } catch (const IncompatibleInputs& error) {
    throw IncompatibleInputs(name + ": " + error.what());
  } catch (const std::bad_alloc&) {
    throw Error(name + ": not enough memory");
  } catch (const std::exception& error) {
    throw Error(name + ": " + error.what());
  }
}

Values read_inputs(const Recipe& recipe, const Step& step, Values connected, const GridFrame* raster,
                   const RunContext& run) {
  Values in = std::move(connected);
  GridFrame frame = raster != nullptr ? *raster : recipe.domain;
  bool first = raster == nullptr;
  for (const Port& port : step.op->in) {  // in their order: a terrain before the labels that may be painted over it
    const auto source = step.in.find(port.name);
    if (source == step.in.end()) continue;
    if (source->second.from_file())
      in[port.name] = read_file(port, resolve_file(recipe, source->second.file), frame,
                                port.placing == Placing::system || !first, run);
    if (port.kind != &kinds::Terrain::kind() || port.placing == Placing::anywhere || !first) continue;
    frame = *in[port.name].frame();
    first = false;
  }
  return in;
}

Values run_step(const Recipe& recipe, const Step& step, Values connected, const RunContext& run) {
  try {
    const Together together =
        bring_together(*step.op, read_inputs(recipe, step, std::move(connected), nullptr, run), recipe.domain, run);
    return step.op->run(step.params, together.in,
                        {together.domain, recipe.domain_stated, step.seed, recipe.folder, run});
  } catch (...) {
    rethrow_with_step(step);
  }
}

}  // namespace seamount::recipe
