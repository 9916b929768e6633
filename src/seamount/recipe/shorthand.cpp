#include "seamount/recipe/shorthand.h"

#include <algorithm>
#include <filesystem>

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

/// As in_rows() names its inputs (ports.h).
std::string row_suffix(int row) { return row == 0 ? "" : "_" + std::to_string(row + 1); }

}  // namespace

const Port* meant_output(const Operator& producer, const std::string& input, const std::vector<const Kind*>& kinds) {
  const auto fits = [&](const Port& port) {
    return kinds.empty() || std::find(kinds.begin(), kinds.end(), port.kind) != kinds.end();
  };
  const Port* same = producer.find_out(input);
  return same != nullptr && fits(*same) ? same : only_one(producer.out, fits);
}

const Port* meant_written(const Operator& producer, const std::vector<const Kind*>& kinds) {
  if (const Port* only = meant_output(producer, "", kinds)) return only;
  const Port& first = producer.out.front();
  return std::find(kinds.begin(), kinds.end(), first.kind) != kinds.end() ? &first : nullptr;
}

int count_rows(const Operator& consumer) {
  if (consumer.in.empty()) return 0;
  int rows = 1;
  while (consumer.find_in(consumer.in.front().name + row_suffix(rows)) != nullptr) ++rows;
  return rows == 1 ? 0 : rows;
}

std::vector<std::pair<const Port*, const Port*>> row_connections(const Operator& consumer, const Operator& producer,
                                                                 int row) {
  std::vector<std::pair<const Port*, const Port*>> pairs;
  for (const Port& output : producer.out) {
    const Port* input = consumer.find_in(output.name + row_suffix(row));
    if (input != nullptr && input->kind == output.kind) pairs.emplace_back(input, &output);
  }
  return pairs;
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

std::vector<std::string> ways_by_name(const Registry& registry, const std::string& path, const Kind& kind) {
  const std::string extension = std::filesystem::path(path).extension().string();
  std::vector<std::string> names;
  for (const auto& format : registry.formats()) {
    const auto& endings = format->extensions;
    if (format->claims.empty() && format->takes(kind) &&
        std::find(endings.begin(), endings.end(), extension) != endings.end())
      names.push_back(format->name);
  }
  return names;
}

std::vector<const Kind*> kinds_by_name(const Registry& registry, const std::string& path) {
  std::vector<const Kind*> kinds;
  for (const Kind* kind : registry.kinds()) {
    if (!ways_by_name(registry, path, *kind).empty()) kinds.push_back(kind);
  }
  return kinds;
}

}  // namespace seamount::recipe
