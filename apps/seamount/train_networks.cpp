// train sketch, island: networks from data, in pieces that go on after a kill.
#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "seamount/base/printable.h"
#include "seamount/recipe/param_json.h"
#include "seamount/train/island_task.h"
#include "seamount/train/sketch_task.h"
#include "seamount/train/training.h"
#include "train_command.h"

namespace seamount::app {
namespace {

using recipe::Json;

struct TrainFlags : RunFlags {
  std::string out, from, dem;
  std::map<std::string, std::string> params;
};

template <class Params>
Params read_flags(const std::map<std::string, std::string>& given) {
  Json json = Json::object();
  for (const recipe::ParamInfo& info : recipe::describe_params<Params>()) {
    const auto found = given.find(info.name);
    if (found != given.end()) json[info.name] = recipe::parse_flag(info, found->second);
  }
  recipe::Diagnostics diagnostics;
  const auto params = recipe::read_params<Params>(json, {"", diagnostics});
  if (!diagnostics.empty()) throw_as_flag(diagnostics.items().front(), "train", {{"/", "--"}});
  return params;
}

void train_on(const train::Task& task, const TrainFlags& flags, const Session& session) {
  const auto params = read_flags<train::TrainingParams>(flags.params);
  const std::filesystem::path folder = flags.out;
  std::filesystem::create_directories(folder);
  const train::TrainingFiles files{(folder / (task.name() + ".safetensors")).string(),
                                   (folder / (task.name() + ".checkpoint")).string(), (folder / "samples").string(),
                                   flags.from};
  const train::Check best = train::train_network(
      task, params, files, Seed{flags.seed.value_or(0)}, [](const std::string& line) { print_message(line); },
      session.run());
  fmt::print("{}: {} samples, mean error {:.4f}, of means over 8 cells {:.4f}, roughness off by {:.3f}\n",
             printable(files.weights), best.samples, best.error, best.coarse_error, best.roughness);
}

Command add_kind(Command train, const std::shared_ptr<TrainFlags>& flags, const std::string& name,
                 const std::string& summary) {
  Command kind = train.add_command(name, summary);
  kind.add("--out", &flags->out, "folder of weights, checkpoint and sample pictures; an earlier run goes on")
      .required();
  kind.add("--from", &flags->from, "weights to start from, where there is no checkpoint");
  add_run_flags(kind, *flags);
  for (const recipe::ParamInfo& info : recipe::describe_params<train::TrainingParams>()) {
    kind.add(
            "--" + info.name, [flags, param = info.name](const std::string& text) { flags->params[param] = text; },
            info.help)
        .kind(info.kind);
  }
  return kind;
}

}  // namespace

void add_train_networks(Command command) {
  const auto flags = std::make_shared<TrainFlags>();
  Command sketch = add_kind(command, flags, "sketch", "Ridges, rivers, heights and known ground to terrain");
  sketch.add("--dem", &flags->dem, "folder of elevation models (GeoTIFF)").required();
  sketch.does([flags] {
    const Session session(*flags);
    const train::SketchTask task(flags->dem, 256, Seed{flags->seed.value_or(0)}, session.run());
    train_on(task, *flags, session);
  });
  Command island = add_kind(command, flags, "island", "Maps of regions to islands, learned from the island generator");
  island.does([flags] {
    const Session session(*flags);
    const train::IslandTask task(Seed{flags->seed.value_or(0)});
    train_on(task, *flags, session);
  });
}

}  // namespace seamount::app
