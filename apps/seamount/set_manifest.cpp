#include "set_manifest.h"

#include <fmt/format.h>

#include <fstream>
#include <utility>

#include "seamount/base/error.h"
#include "seamount/recipe/param_json.h"

namespace seamount::app {
namespace {

using recipe::Json;

std::string name_of(uint64_t index, const char* kind) { return fmt::format("{:06}_{}.png", index, kind); }

std::string text_of(const Json& json, const std::string& name) {
  const auto member = json.find(name);
  if (member == json.end() || !member->is_string()) throw Error("\"" + name + "\" is missing");
  return member->get<std::string>();
}

Json parsed_line(const std::string& line) {
  Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) throw Error("is not a JSON object");
  return json;
}

/// What sample_line() says of files.
train::SampleRecord read_files(const SetSort& sort, const Json& json) {
  train::SampleRecord record;
  for (const char* kind : sort.kinds) record.digests.push_back(text_of(json, std::string(kind) + "_digest"));
  const auto index = json.find("index");
  if (index == json.end() || !index->is_number_unsigned()) throw Error("\"index\" is missing");
  record.index = index->get<uint64_t>();
  for (const char* kind : sort.kinds)
    if (text_of(json, kind) != name_of(record.index, kind)) throw Error("names files of another sample");
  return record;
}

void throw_first(const recipe::Diagnostics& diagnostics) {
  if (!diagnostics.empty()) throw Error(diagnostics.items().front().message);
}

train::StoredSketch stored_sketch(const std::string& line) {
  read_sketch_line(line);
  const Json json = parsed_line(line);
  recipe::Diagnostics diagnostics;
  return {json["index"].get<uint64_t>(), text_of(json, "tile"),
          recipe::read_params<train::SketchDraw>(json["drawn"], {"/drawn", diagnostics})};
}

/// Calls take() with each line behind the first.
void read_lines(const std::string& folder, const std::function<void(const std::string&)>& take) {
  const std::string path = folder + "/manifest.jsonl";
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  for (int number = 2; std::getline(file, line); ++number) {
    try {
      take(line);
    } catch (const Error& error) {
      throw Error(fmt::format("{}, line {}: {}", path, number, error.what()));
    }
  }
}

template <class Params>
Params shared_params(const std::string& folder, const SetSort& sort) {
  const std::optional<SetOf> set = find_set(folder, sort, "--set");
  if (!set) throw InvalidArgument("--set", folder + " holds no set of samples (seamount dataset " + sort.name + ")");
  recipe::Diagnostics diagnostics;
  const auto params = recipe::read_params<Params>(set->params, {"/params", diagnostics});
  throw_first(diagnostics);
  return params;
}

}  // namespace

const SetSort& island_sets() {
  static const SetSort sort{"islands", train::kIslandFiles};
  return sort;
}
const SetSort& sketch_sets() {
  static const SetSort sort{"sketches", train::kSketchFiles};
  return sort;
}

std::string sample_line(const SetSort& sort, uint64_t index, const std::vector<std::string>& digests, Json drawn) {
  drawn["index"] = index;
  for (size_t k = 0; k < sort.kinds.size(); ++k) {
    const std::string kind = sort.kinds[k];
    drawn[kind] = name_of(index, sort.kinds[k]);
    drawn[kind + "_digest"] = digests[k];
  }
  return drawn.dump();
}

train::SampleRecord read_island_line(const std::string& line) {
  const Json json = parsed_line(line);
  train::SampleRecord record = read_files(island_sets(), json);
  recipe::Diagnostics diagnostics;
  recipe::read_params<train::Augmentation>(json.value("augmentation", Json()), {"/augmentation", diagnostics});
  const Json islands = json.value("islands", Json());
  if (!islands.is_array()) throw Error("\"islands\" is missing");
  for (const Json& island : islands) recipe::read_params<train::IslandDraw>(island, {"/islands", diagnostics});
  throw_first(diagnostics);
  return record;
}

train::SampleRecord read_sketch_line(const std::string& line) {
  const Json json = parsed_line(line);
  train::SampleRecord record = read_files(sketch_sets(), json);
  text_of(json, "tile");
  recipe::Diagnostics diagnostics;
  recipe::read_params<train::SketchDraw>(json.value("drawn", Json()), {"/drawn", diagnostics});
  throw_first(diagnostics);
  return record;
}

std::optional<SetOf> find_set(const std::string& folder, const SetSort& sort, const std::string& flag) {
  const std::optional<std::string> header = train::find_set_header(folder);
  if (!header) return std::nullopt;
  const Json json = Json::parse(*header, nullptr, false);
  const bool known = json.is_object() && json.value("kind", Json()) == sort.name &&
                     json.value("seed", Json()).is_number_unsigned() && json.value("params", Json()).is_object();
  if (!known) {
    throw InvalidArgument(flag,
                          folder + "/manifest.jsonl does not begin with the line of a set (\"" + sort.name + "\")");
  }
  return SetOf{json["params"], json["seed"].get<uint64_t>()};
}

StoredSketches read_stored_sketches(const std::string& folder) {
  StoredSketches set{shared_params<train::SketchSetParams>(folder, sketch_sets()).size, {}};
  read_lines(folder, [&](const std::string& line) { set.examples.push_back(stored_sketch(line)); });
  return set;
}

StoredIslands read_stored_islands(const std::string& folder) {
  StoredIslands set{shared_params<train::IslandSetParams>(folder, island_sets()), 0};
  read_lines(folder, [&](const std::string& line) {
    if (read_island_line(line).index != set.count++) throw Error("is the line of another sample");
  });
  return set;
}

}  // namespace seamount::app
