// dataset: training pairs on disk.
#include <fmt/format.h>

#include <iostream>

#include "app.h"
#include "seamount/base/version.h"
#include "seamount/train/island_set.h"

namespace seamount::app {
namespace {

using recipe::Json;

struct DatasetFlags : RunFlags {
  std::string out;
  uint64_t count = 0;
  std::optional<uint64_t> only;
  std::map<std::string, std::string> params;
};

/// Line of the manifest: the set's, or a sample's.
std::string manifest_line(const train::IslandSetParams& params, uint64_t seed, const train::IslandSample* sample) {
  if (sample == nullptr) {
    return Json{{"kind", "islands"}, {"seamount", kVersion}, {"seed", seed}, {"params", recipe::write_params(params)}}
        .dump();
  }
  Json islands = Json::array();
  for (const train::IslandDraw& island : sample->islands) islands.push_back(recipe::write_params(island));
  return Json{{"index", sample->index},
              {"subsidence", sample->subsidence},
              {"labels", fmt::format("{:06}_labels.png", sample->index)},
              {"height", fmt::format("{:06}_height.png", sample->index)},
              {"islands", islands},
              {"augmentation", recipe::write_params(sample->augmentation)}}
      .dump();
}

train::IslandSetParams read_set_params(const DatasetFlags& flags) {
  Json given = Json::object();
  for (const recipe::ParamInfo& info : recipe::describe_params<train::IslandSetParams>()) {
    const auto found = flags.params.find(info.name);
    if (found != flags.params.end()) given[info.name] = recipe::parse_flag(info, found->second);
  }
  recipe::Diagnostics diagnostics;
  const auto params = recipe::read_params<train::IslandSetParams>(given, {"", diagnostics});
  if (!diagnostics.empty()) throw_as_flag(diagnostics.items().front(), "dataset", {{"/", "--"}});
  return params;
}

void make_islands(const DatasetFlags& flags) {
  const train::IslandSetParams params = read_set_params(flags);
  const Seed seed{flags.seed.value_or(0)};
  const Session session(flags);
  if (flags.only) {
    train::IslandSample sample = train::draw_island_sample(params, *flags.only, seed);
    train::make_island_files(params, sample, seed, flags.out, session.run());
    std::cout << manifest_line(params, seed.value, &sample) << "\n";
    return;
  }
  const train::IslandSetOptions options{flags.out, flags.count, seed, [&](const train::IslandSample* sample) {
                                          return manifest_line(params, seed.value, sample);
                                        }};
  const train::IslandSetReport report = train::make_island_set(params, options, session.run());
  fmt::print("{}: {} samples made, {} were there\n", flags.out, report.made, report.present);
}

}  // namespace

void add_dataset_command(Command program) {
  const auto flags = std::make_shared<DatasetFlags>();
  Command command = program.add_command("dataset", "Make training pairs");
  command.require_command();
  Command islands =
      command.add_command("islands", "Label maps and height fields of islands; goes on where an earlier run ended");
  islands.add("--count", &flags->count, "samples in the set").between(1, 100000000);
  islands.add("--out", &flags->out, "folder of the set").required();
  islands.add("--only", &flags->only, "make this one sample alone").whole();
  add_run_flags(islands, *flags);
  for (const recipe::ParamInfo& info : recipe::describe_params<train::IslandSetParams>()) {
    islands
        .add(
            "--" + info.name, [flags, name = info.name](const std::string& text) { flags->params[name] = text; },
            info.help)
        .kind(info.kind);
  }
  islands.does([flags] {
    if (flags->out.empty()) throw InvalidArgument("--out", "a folder name is needed");
    if (flags->count == 0 && !flags->only) throw InvalidArgument("--count", "is missing: how many samples?");
    make_islands(*flags);
  });
}

}  // namespace seamount::app
