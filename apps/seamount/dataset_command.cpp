// dataset: training pairs on disk.
#include <fmt/format.h>

#include <iostream>
#include <span>

#include "app.h"
#include "seamount/base/printable.h"
#include "seamount/base/version.h"
#include "seamount/train/island_set.h"
#include "seamount/train/sample_set.h"
#include "seamount/train/sketch_set.h"

namespace seamount::app {
namespace {

using recipe::Json;

struct DatasetFlags : RunFlags {
  std::string out, dem;
  uint64_t count = 0;
  std::optional<uint64_t> only;
  std::map<std::string, std::string> params;
};

using Kinds = std::span<const char* const>;

/// A set of one sort: how its lines are written and read.
struct Sort {
  std::string name;  ///< "islands"
  Kinds kinds;       ///< of files
};

const Sort kIslands{"islands", train::kIslandFiles}, kSketches{"sketches", train::kSketchFiles};

std::string name_of(uint64_t index, const char* kind) { return fmt::format("{:06}_{}.png", index, kind); }

/// The line of a sample: its files, and what was drawn.
std::string sample_line(const Sort& sort, uint64_t index, const std::vector<std::string>& digests, Json drawn) {
  drawn["index"] = index;
  for (size_t k = 0; k < sort.kinds.size(); ++k) {
    const std::string kind = sort.kinds[k];
    drawn[kind] = name_of(index, sort.kinds[k]);
    drawn[kind + "_digest"] = digests[k];
  }
  return drawn.dump();
}

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
train::SampleRecord read_files(const Sort& sort, const Json& json) {
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

train::SampleRecord read_island_line(const std::string& line) {
  const Json json = parsed_line(line);
  train::SampleRecord record = read_files(kIslands, json);
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
  train::SampleRecord record = read_files(kSketches, json);
  text_of(json, "tile");
  recipe::Diagnostics diagnostics;
  recipe::read_params<train::SketchDraw>(json.value("drawn", Json()), {"/drawn", diagnostics});
  throw_first(diagnostics);
  return record;
}

/// What the samples of a set share.
struct SetOf {
  Json params = Json::object();
  uint64_t seed = 0;
};

/// What the manifest in the folder says, where there is one.
SetOf find_set(const std::string& folder, const Sort& sort) {
  const std::optional<std::string> header = train::find_set_header(folder);
  if (!header) return {};
  const Json json = Json::parse(*header, nullptr, false);
  const bool known = json.is_object() && json.value("kind", Json()) == sort.name &&
                     json.value("seed", Json()).is_number_unsigned() && json.value("params", Json()).is_object();
  if (!known) {
    throw InvalidArgument("--out",
                          folder + "/manifest.jsonl does not begin with the line of a set (\"" + sort.name + "\")");
  }
  return {json["params"], json["seed"].get<uint64_t>()};
}

/// The set's own parameters, else those of the flags. Flags that say something else are found out by the header.
template <class Params>
Params read_set_params(const DatasetFlags& flags, const SetOf& set) {
  Json given = set.params;
  for (const recipe::ParamInfo& info : recipe::describe_params<Params>()) {
    const auto found = flags.params.find(info.name);
    if (found != flags.params.end()) given[info.name] = recipe::parse_flag(info, found->second);
  }
  recipe::Diagnostics diagnostics;
  const auto params = recipe::read_params<Params>(given, {"", diagnostics});
  if (!diagnostics.empty()) throw_as_flag(diagnostics.items().front(), "dataset", {{"/", "--"}});
  return params;
}

/// First line of the manifest, of which `about` is a part.
template <class Params>
std::string header_line(const Sort& sort, const Params& params, Seed seed, Json about = Json::object()) {
  about["kind"] = sort.name;
  about["seamount"] = kVersion;
  about["seed"] = seed.value;
  about["params"] = recipe::write_params(params);
  return about.dump();
}

/// Makes the set, or the one sample that is wanted.
void make_set(const DatasetFlags& flags, const Sort& sort, train::SampleSet set, const Session& session) {
  set.folder = flags.out;
  set.count = flags.count;
  set.kinds.assign(sort.kinds.begin(), sort.kinds.end());
  if (flags.only) {
    train::check_set_header(set.folder, set.header);
    std::cout << set.make(*flags.only, session.run()) << "\n";
    return;
  }
  const train::SampleSetReport report = train::make_sample_set(set, session.run());
  fmt::print("{}: {} samples made, {} were there\n", printable(flags.out), report.made, report.present);
}

void make_islands(const DatasetFlags& flags) {
  const SetOf set = find_set(flags.out, kIslands);
  const auto params = read_set_params<train::IslandSetParams>(flags, set);
  const Seed seed{flags.seed.value_or(set.seed)};
  const auto make = [&](uint64_t index, const RunContext& run) {
    train::IslandSample sample = train::draw_island_sample(params, index, seed);
    const std::vector<std::string> digests = train::make_island_files(params, sample, seed, flags.out, run);
    Json islands = Json::array();
    for (const train::IslandDraw& island : sample.islands) islands.push_back(recipe::write_params(island));
    return sample_line(kIslands, index, digests,
                       {{"subsidence", sample.subsidence},
                        {"islands", islands},
                        {"augmentation", recipe::write_params(sample.augmentation)}});
  };
  make_set(flags, kIslands, {.header = header_line(kIslands, params, seed), .make = make, .read = read_island_line},
           Session(flags));
}

void make_sketches(const DatasetFlags& flags) {
  const SetOf set = find_set(flags.out, kSketches);
  const auto params = read_set_params<train::SketchSetParams>(flags, set);
  const Seed seed{flags.seed.value_or(set.seed)};
  const Session session(flags);
  const std::vector<train::GroundTile> tiles = train::read_sketch_ground(flags.dem, params, session.run());
  const auto make = [&](uint64_t index, const RunContext& run) {
    const train::SketchExample made = train::make_sketch_files(tiles, params, index, seed, flags.out, run);
    return sample_line(kSketches, index, made.digests,
                       {{"tile", printable(made.tile)}, {"drawn", recipe::write_params(made.draw)}});
  };
  const std::string header = header_line(kSketches, params, seed, {{"ground", train::ground_digest(tiles).hex()}});
  make_set(flags, kSketches, {.header = header, .make = make, .read = read_sketch_line}, session);
}

template <class Params>
Command add_sort(Command command, const std::shared_ptr<DatasetFlags>& flags, const Sort& sort,
                 const std::string& summary, void (*make)(const DatasetFlags&)) {
  Command added = command.add_command(sort.name, summary + "; goes on where an earlier run ended");
  added.add("--count", &flags->count, "samples in the set").between(1, 100000000);
  added.add("--out", &flags->out, "folder of the set").required();
  added.add("--only", &flags->only, "make this one sample alone").whole();
  add_run_flags(added, *flags);
  for (const recipe::ParamInfo& info : recipe::describe_params<Params>()) {
    added
        .add(
            "--" + info.name, [flags, name = info.name](const std::string& text) { flags->params[name] = text; },
            info.help)
        .kind(info.kind);
  }
  added.does([flags, make] {
    if (flags->out.empty()) throw InvalidArgument("--out", "a folder name is needed");
    if (flags->count == 0 && !flags->only) throw InvalidArgument("--count", "is missing: how many samples?");
    make(*flags);
  });
  return added;
}

}  // namespace

void add_dataset_command(Command program) {
  const auto flags = std::make_shared<DatasetFlags>();
  Command command = program.add_command("dataset", "Make training pairs");
  command.require_command();
  add_sort<train::IslandSetParams>(command, flags, kIslands, "Label maps and height fields of islands", make_islands);
  add_sort<train::SketchSetParams>(command, flags, kSketches, "Real ground and sketches of it", make_sketches)
      .add("--dem", &flags->dem, "folder of elevation models: GeoTIFF, HGT")
      .required();
}

}  // namespace seamount::app
