#include "seamount/tiles/local_step.h"

#include <algorithm>

#include "seamount/recipe/one_frame.h"
#include "seamount/recipe/step_work.h"
#include "seamount/tiles/relief.h"
#include "seamount/tiles/windows.h"

namespace seamount::tiles {
namespace {

using recipe::Port, recipe::Step, recipe::Values;

bool is_whole(const GridFrame& frame, const Rect& rect) { return rect == Rect{0, 0, frame.width, frame.height}; }

GridFrame window_frame(const GridFrame& frame, const Rect& rect) {
  return is_whole(frame, rect) ? frame : frame.window(rect.column, rect.row, rect.width, rect.height);
}

/// The inputs that it looks at as wholes, beside a raster or in the domain.
void bring_wholes(const World& world, const Step& step, LocalStep& made, const RunContext& run) {
  const bool beside = !made.inputs.empty();
  Values in = recipe::read_inputs(world.recipe(), step, std::move(made.wholes), beside ? &made.frame : nullptr, run);
  made.domain = world.recipe().domain;
  if (!beside) {
    recipe::Together together = recipe::bring_together(*step.op, std::move(in), world.recipe().domain, run);
    made.wholes = std::move(together.in);
    made.domain = made.frame = together.domain;
    return;
  }
  for (auto& [name, value] : in)
    value =
        recipe::brought_beside(*step.op->find_in(name), value, made.frame, "'" + made.inputs[0].port->name + "'", run);
  made.domain = recipe::placed_domain(made.domain, Extent::of(made.frame));
  made.wholes = std::move(in);
}

/// Parameters that the relief of the whole has told of it; as they are where its values are beyond what may be stated.
recipe::Json settled(const recipe::Operator& op, const recipe::Json& params, const Relief& relief) {
  recipe::Json made = op.settled(params, relief.lowest, relief.highest);
  recipe::Diagnostics diagnostics;
  op.complete(made, {"", diagnostics});
  return diagnostics.empty() ? made : params;
}

}  // namespace

std::optional<Locality> locality(const World& world, size_t index,
                                 const std::function<const GridFrame&(const OutputOf&)>& frame_of) {
  const Step& step = world.step(index);
  if (!step.op->reach) return std::nullopt;
  for (const Port& port : step.op->out) {
    if (!is_raster(*port.kind)) return std::nullopt;
  }
  Locality found;
  for (const Port& port : step.op->in) {
    const auto source = step.in.find(port.name);
    if (source == step.in.end()) continue;
    if (is_raster(*port.kind) && port.placing == recipe::Placing::cells) {
      if (source->second.from_file()) return std::nullopt;  // read as a whole anyhow
      found.inputs.push_back({&port, world.output_of(source->second)});
    } else if (!source->second.from_file()) {
      found.wholes.push_back(world.output_of(source->second));
    }
  }
  for (const LocalStep::Input& input : found.inputs) {
    if (!(frame_of(input.from) == frame_of(found.inputs[0].from))) return std::nullopt;  // brought onto its cells
  }
  if (step.op->settled && !found.inputs.empty())
    found.measured = !step.op->reach(step.params, frame_of(found.inputs[0].from).cell_m).local();
  return found;
}

std::optional<LocalStep> local_step(const World& world, size_t index, const Locality& found,
                                    const std::function<const GridFrame&(const OutputOf&)>& frame_of,
                                    const RunContext& run, const recipe::Json* params) {
  const Step& step = world.step(index);
  const recipe::Json& given = params != nullptr ? *params : step.params;
  LocalStep made;
  made.index = index;
  made.inputs = found.inputs;
  if (!found.inputs.empty()) made.frame = frame_of(found.inputs[0].from);
  for (const auto& [port, source] : step.in) {
    const bool by_windows = std::any_of(found.inputs.begin(), found.inputs.end(),
                                        [&, &name = port](const auto& input) { return input.port->name == name; });
    if (!source.from_file() && !by_windows) made.wholes[port] = world.whole(world.output_of(source));
  }
  std::optional<Relief> relief;
  if (found.measured && !(relief = relief_of(world, found.inputs[0].from, run))) throw MeetsUnknown{index};
  try {
    bring_wholes(world, step, made, run);
    made.params = relief ? settled(*step.op, given, *relief) : given;
    made.reach = step.op->reach(made.params, made.frame.cell_m);
  } catch (...) {
    recipe::rethrow_with_step(step);
  }
  if (!made.reach.local() || made.reach.cells >= std::max(made.frame.width, made.frame.height)) return std::nullopt;
  return made;
}

Values LocalStep::run(const World& world, const Rect& rect, const std::vector<recipe::Value>& windows,
                      const RunContext& run) const {
  const Step& step = world.step(index);
  Values in = wholes;
  for (size_t i = 0; i < inputs.size(); ++i) {
    const bool as_it_is = inputs[i].port->voids && !reach.known;
    if (!as_it_is && has_unknown(windows[i])) throw MeetsUnknown{index};
    in[inputs[i].port->name] = windows[i];
  }
  const GridFrame seen = domain == frame ? window_frame(domain, rect) : domain;
  try {
    Values out =
        step.op->run(params, in, {seen, world.recipe().domain_stated, step.seed, world.recipe().folder, run, &frame});
    for (const auto& [port, value] : out) {
      if (value.frame()->width != rect.width || value.frame()->height != rect.height)
        throw Error("makes a raster of other cells than it was taken for; this is a mistake of Seamount's");
    }
    return out;
  } catch (...) {
    recipe::rethrow_with_step(step);
  }
}

}  // namespace seamount::tiles
