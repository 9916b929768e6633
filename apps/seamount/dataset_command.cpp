// dataset: training pairs on disk.
#include <fmt/format.h>

#include <iostream>

#include "app.h"
#include "seamount/base/printable.h"
#include "seamount/base/version.h"
#include "seamount/train/island_set.h"
#include "seamount/train/sample_set.h"
#include "seamount/train/sketch_set.h"
#include "set_manifest.h"

namespace seamount::app {
namespace {

using recipe::Json;

struct DatasetFlags : RunFlags {
  std::string out, dem;
  uint64_t count = 0;
  std::optional<uint64_t> only;
  std::map<std::string, std::string> params;
};

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
std::string header_line(const SetSort& sort, const Params& params, Seed seed, Json about = Json::object()) {
  about["kind"] = sort.name;
  about["seamount"] = kVersion;
  about["seed"] = seed.value;
  about["params"] = recipe::write_params(params);
  return about.dump();
}

/// Makes the set, or the one sample that is wanted.
void make_set(const DatasetFlags& flags, const SetSort& sort, train::SampleSet set, const Session& session) {
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
  const SetOf set = find_set(flags.out, island_sets(), "--out").value_or(SetOf{});
  const auto params = read_set_params<train::IslandSetParams>(flags, set);
  const Seed seed{flags.seed.value_or(set.seed)};
  const auto make = [&](uint64_t index, const RunContext& run) {
    train::IslandSample sample = train::draw_island_sample(params, index, seed);
    const std::vector<std::string> digests = train::make_island_files(params, sample, seed, flags.out, run);
    Json islands = Json::array();
    for (const train::IslandDraw& island : sample.islands) islands.push_back(recipe::write_params(island));
    return sample_line(island_sets(), index, digests,
                       {{"subsidence", sample.subsidence},
                        {"islands", islands},
                        {"augmentation", recipe::write_params(sample.augmentation)}});
  };
  make_set(flags, island_sets(),
           {.header = header_line(island_sets(), params, seed), .make = make, .read = read_island_line},
           Session(flags));
}

void make_sketches(const DatasetFlags& flags) {
  const SetOf set = find_set(flags.out, sketch_sets(), "--out").value_or(SetOf{});
  const auto params = read_set_params<train::SketchSetParams>(flags, set);
  const Seed seed{flags.seed.value_or(set.seed)};
  const Session session(flags);
  const std::vector<train::GroundTile> tiles = train::read_sketch_ground(flags.dem, params, session.run());
  const auto make = [&](uint64_t index, const RunContext& run) {
    const train::SketchExample made = train::make_sketch_files(tiles, params, index, seed, flags.out, run);
    return sample_line(sketch_sets(), index, made.digests,
                       {{"tile", printable(made.tile)}, {"drawn", recipe::write_params(made.draw)}});
  };
  const std::string header = header_line(sketch_sets(), params, seed, {{"ground", train::ground_digest(tiles).hex()}});
  make_set(flags, sketch_sets(), {.header = header, .make = make, .read = read_sketch_line}, session);
}

template <class Params>
Command add_sort(Command command, const std::shared_ptr<DatasetFlags>& flags, const SetSort& sort,
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
  add_sort<train::IslandSetParams>(command, flags, island_sets(), "Label maps and height fields of islands",
                                   make_islands);
  add_sort<train::SketchSetParams>(command, flags, sketch_sets(), "Real ground and sketches of it", make_sketches)
      .add("--dem", &flags->dem, "folder of elevation models: GeoTIFF, HGT")
      .required();
}

}  // namespace seamount::app
