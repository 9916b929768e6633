#include "seamount/recipe/prepare_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "seamount/recipe/kinds.h"
#include "seamount/recipe/shorthand.h"

namespace seamount::recipe {
namespace {

/// "by its ending to .tif, .asc; with "as": one of unreal (.png, .r16), perspective (.png)".
std::string what_can_be_written(const Registry& registry, const Kind& kind) {
  std::string endings, named;
  for (const auto& format : registry.formats()) {
    if (!format->takes(kind)) continue;
    for (const std::string& ending : format->claims) endings += (endings.empty() ? "" : ", ") + ending;
    if (format->claims.empty())
      named += fmt::format("{}{} ({})", named.empty() ? "" : ", ", format->name, written_to(*format));
  }
  return (endings.empty() ? "" : "by its ending to " + endings) + (endings.empty() || named.empty() ? "" : "; ") +
         (named.empty() ? "" : "with \"as\": one of " + named);
}

void report_no_format(const Registry& registry, const Kind& kind, const std::optional<std::string>& as,
                      const std::string& path, const ReadPlace& place) {
  std::vector<std::string> names;
  for (const auto& format : registry.formats()) {
    if (format->takes(kind)) names.push_back(format->name);
  }
  if (as) {
    place.at("as").fail(fmt::format("'{}' is no way to write {}{}", *as, kind.name, suggestion(*as, names)));
  } else if (const auto ways = ways_by_name(registry, path, kind);
             !ways.empty() && std::filesystem::path(path).has_extension()) {
    place.at("path").fail(fmt::format("'{}' does not say how to write {}: add \"as\": \"{}\"", path, kind.name,
                                      fmt::join(ways, "\", or \"")));
  } else if (names.size() == 1) {
    place.at("path").fail(fmt::format("'{}' is written to {}, not to '{}'", names.front(),
                                      written_to(*registry.find_format(names.front())), path));
  } else {
    place.at("path").fail(fmt::format("'{}' does not say how to write {}: that goes {}", path, kind.name,
                                      what_can_be_written(registry, kind)));
  }
}

/// The step that makes something of an output's value.
Step preparing_step(const Recipe& recipe, const Output& output, const Preparation& wanted, const Kind& kind,
                    const std::optional<Source>& labels, const ReadPlace& place) {
  Step step;
  step.id = output.path + (wanted.name.empty() ? "" : " " + wanted.name);
  step.output = output.path;
  step.op = recipe.registry->find_operator(wanted.op);
  step.params = step.op->complete(wanted.params, place);
  step.seed = recipe.seed;
  for (const Port& port : step.op->in) {
    if (port.kind == &kind && step.in.empty()) step.in[port.name] = output.from;
    if (port.kind == &kinds::Labels::kind() && labels) step.in[port.name] = *labels;
  }
  return step;
}

}  // namespace

std::string add_once(std::vector<Step>& steps, Step step) {
  const auto same = std::find_if(steps.begin(), steps.end(), [&](const Step& other) {
    return other.op == step.op && !step.op->stochastic && other.in == step.in && other.params == step.params;
  });
  if (same != steps.end()) return same->id;
  steps.push_back(std::move(step));
  return steps.back().id;
}

std::string written_to(const OutputFormat& format) {
  const std::string list = fmt::format("{}", fmt::join(format.extensions, ", "));
  return list.empty() ? "a folder" : list;
}

bool choose_format(const Registry& registry, const Kind& kind, const std::optional<std::string>& as, Output& output,
                   const ReadPlace& place) {
  output.format = as ? registry.find_format(*as) : registry.format_for(output.path, kind);
  if (output.format == nullptr || !output.format->takes(kind)) {
    report_no_format(registry, kind, as, output.path, place);
    return false;
  }
  const std::string extension = std::filesystem::path(output.path).extension().string();
  const auto& allowed = output.format->extensions;
  if (allowed.empty() || std::find(allowed.begin(), allowed.end(), extension) != allowed.end()) return true;
  place.at("path").fail(
      fmt::format("'{}' is written to {}, not to '{}'", output.format->name, written_to(*output.format), output.path));
  return false;
}

void prepare_output(Recipe& recipe, Output& output, const Kind& kind, const std::optional<Source>& labels,
                    const std::map<std::string, Source>& drawn, const ReadPlace& place) {
  const OutputFormat& format = *output.format;
  output.files = format.files ? format.files(output.params, kind, output.path) : std::vector{output.path};
  if (!format.prepare) return;
  const Output written = output;
  std::vector<Preparation> preparations;
  try {
    preparations = format.prepare(output.params, kind, output.path);
  } catch (const InvalidArgument& error) {
    return place.fail(error);
  }
  for (const Preparation& wanted : preparations) {
    Step step = preparing_step(recipe, written, wanted, kind, labels, place);
    for (const auto& [input, source] : drawn)
      if (wanted.name.empty()) step.in[input] = source;
    const std::string id = add_once(recipe.steps, std::move(step));
    (wanted.name.empty() ? output.from : output.prepared[wanted.name]) = Source{id, wanted.port, ""};
  }
}

}  // namespace seamount::recipe
