#include "seamount/recipe/shorthand.h"

#include <algorithm>

namespace seamount::recipe {
namespace {

/// The only port that fits; nullptr for none and for several.
template <class Fits>
const Port* only_one(const std::vector<Port>& ports, Fits fits) {
  const Port* found = nullptr;
  for (const Port& port : ports) {
    if (!fits(port)) continue;
    if (found != nullptr) return nullptr;
    found = &port;
  }
  return found;
}

}  // namespace

const Port* meant_output(const Operator& producer, const std::string& input, const std::vector<const Kind*>& kinds) {
  const auto fits = [&](const Port& port) {
    return kinds.empty() || std::find(kinds.begin(), kinds.end(), port.kind) != kinds.end();
  };
  const Port* same = producer.find_out(input);
  return same != nullptr && fits(*same) ? same : only_one(producer.out, fits);
}

std::vector<std::pair<const Port*, const Port*>> meant_connections(const Operator& consumer, const Operator& producer) {
  std::vector<std::pair<const Port*, const Port*>> pairs;
  for (const Port& input : consumer.in) {
    const Port* output = producer.find_out(input.name);
    if (output != nullptr && output->kind == input.kind) pairs.emplace_back(&input, output);
  }
  return pairs;
}

const Port* meant_input(const Operator& consumer, const Port& output) {
  const Port* same = consumer.find_in(output.name);
  if (same != nullptr && same->kind == output.kind) return same;
  const Port* only = only_one(consumer.in, [&](const Port& port) { return port.kind == output.kind; });
  if (only != nullptr) return only;
  return only_one(consumer.in, [&](const Port& port) { return port.kind == output.kind && port.required; });
}

std::vector<const Kind*> written_kinds(const Registry& registry, const std::string& path,
                                       const std::optional<std::string>& as) {
  std::vector<const Kind*> kinds;
  for (const Kind* kind : registry.kinds()) {
    const OutputFormat* format = as ? registry.find_format(*as) : registry.format_for(path, *kind);
    if (format != nullptr && format->takes(*kind)) kinds.push_back(kind);
  }
  return kinds;
}

}  // namespace seamount::recipe
