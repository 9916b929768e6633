#include "seamount/recipe/bypass.h"

#include <fmt/format.h>

#include <algorithm>

namespace seamount::recipe {
namespace {

const Step* find_step(const std::vector<Step>& steps, const std::string& id) {
  const auto found = std::find_if(steps.begin(), steps.end(), [&](const Step& step) { return step.id == id; });
  return found == steps.end() ? nullptr : &*found;
}

}  // namespace

const Port* stand_in(const Operator& op, const Port& out) {
  const Port* same = op.find_in(out.name);
  if (same != nullptr && same->kind == out.kind) return same;
  const auto of_kind = [&](const Port& port) { return port.kind == out.kind; };
  if (std::find_if(op.out.begin(), op.out.end(), of_kind)->name != out.name) return nullptr;
  const auto first = std::find_if(op.in.begin(), op.in.end(), of_kind);
  return first == op.in.end() ? nullptr : &*first;
}

std::optional<Source> follow(const std::vector<Step>& bypassed, const Source& source) {
  const Step* step = source.from_file() ? nullptr : find_step(bypassed, source.step);
  if (step == nullptr) return source;
  const Port* out = step->op->find_out(source.port);
  const Port* in = out == nullptr ? nullptr : stand_in(*step->op, *out);
  const auto connected = in == nullptr ? step->in.end() : step->in.find(in->name);
  return connected == step->in.end() ? std::nullopt : std::optional(connected->second);
}

std::string why_nothing(const std::vector<Step>& bypassed, const Source& source) {
  const Step& step = *find_step(bypassed, source.step);
  const Port& out = *step.op->find_out(source.port);
  const std::string start = fmt::format("'{}.{}' is bypassed, and ", source.step, source.port);
  if (const Port* in = stand_in(*step.op, out)) return start + fmt::format("its input '{}' is open", in->name);
  return start + fmt::format("{} has no input to pass on as '{}' ({})", step.op->name, out.name, out.kind->name);
}

}  // namespace seamount::recipe
