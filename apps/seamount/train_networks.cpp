// train sketch, island, erode, measure: networks from data, in pieces that go on after a kill.
#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <iostream>

#include "seamount/base/printable.h"
#include "seamount/io/find_model.h"
#include "seamount/io/weights.h"
#include "seamount/ops/learned/erode_planes.h"
#include "seamount/ops/learned/island_planes.h"
#include "seamount/recipe/draw_again.h"
#include "seamount/recipe/param_json.h"
#include "seamount/train/erode_measures.h"
#include "seamount/train/erode_task.h"
#include "seamount/train/island_measures.h"
#include "seamount/train/island_task.h"
#include "seamount/train/sketch_measures.h"
#include "seamount/train/sketch_task.h"
#include "seamount/train/stored_islands.h"
#include "seamount/train/stored_sketches.h"
#include "seamount/train/training.h"
#include "set_manifest.h"
#include "train_command.h"

namespace seamount::app {
namespace {

using recipe::Json;

struct TrainFlags : RunFlags {
  std::string out, from, dem, set;
  int pairs = 400, size = 192;
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

void add_set(Command kind, const std::shared_ptr<TrainFlags>& flags, const std::string& sort) {
  kind.add("--set", &flags->set, "learn from a set on disk (seamount dataset " + sort + ") instead");
}

struct MeasureFlags : RunFlags {
  std::string model = "sketch", dem;
  int count = 24, size = 256;
};

void print_measures(const train::ComparedMeasures& all, bool json) {
  const std::pair<const char*, const train::SketchMeasures*> columns[] = {
      {"network", &all.made}, {"diffusion", &all.diffused}, {"real", &all.real}};
  Json document = Json::object();
  std::vector<std::pair<std::string, std::vector<double>>> rows;
  const auto row = [&](const std::string& name, const std::function<double(const train::SketchMeasures&)>& value) {
    rows.emplace_back(name, std::vector<double>{});
    for (const auto& [column, measures] : columns) rows.back().second.push_back(value(*measures));
    for (const auto& [column, measures] : columns) document[name][column] = value(*measures);
  };
  row("rivers met", [](const auto& m) { return m.rivers; });
  row("ridges met", [](const auto& m) { return m.ridges; });
  row("heights off", [](const auto& m) { return m.cues; });
  row("pits per km2", [](const auto& m) { return m.pits_km2; });
  row("grid", [](const auto& m) { return m.grid; });
  for (const auto& distance : all.made.distances) {
    const std::string& name = distance.first;
    row(name, [&](const auto& m) { return m.distances.contains(name) ? m.distances.at(name) : 0.0; });
  }
  if (json) {
    fmt::print("{}\n", document.dump());
    return;
  }
  fmt::print("{:<16} {:>10} {:>10} {:>10}\n", fmt::format("{} pieces", all.made.pieces), "network", "diffusion",
             "real");
  for (const auto& [name, values] : rows)
    fmt::print("{:<16} {:>10.3f} {:>10.3f} {:>10.3f}\n", name, values[0], values[1], values[2]);
}

void print_measures(const train::IslandMeasures& measures, bool json) {
  Json document = {{"maps", measures.maps}, {"coast_iou", measures.coast_iou}};
  for (size_t i = 0; i < train::kMapDefects.size(); ++i) {
    document["off"][train::kMapDefects[i]] = measures.off[i];
    document["off_above"][train::kMapDefects[i]] = measures.off_above[i];
  }
  if (json) {
    fmt::print("{}\n", document.dump());
    return;
  }
  fmt::print("{} maps, coast IoU {:.4f}\n{:<10} {:>10} {:>14}\n", measures.maps, measures.coast_iou, "mean |dz|",
             "of range", "above -60 m");
  for (size_t i = 0; i < train::kMapDefects.size(); ++i)
    fmt::print("{:<10} {:>9.2f}% {:>13.2f}%\n", train::kMapDefects[i], 100 * measures.off[i],
               100 * measures.off_above[i]);
}

void print_measures(const std::vector<train::ErodeMeasure>& measures, bool json) {
  if (measures.empty()) throw Error("no terrain changes: more are needed (--count)");
  const train::ErodeMeasure mean = train::mean_of(measures);
  if (json) {
    const Json document = {{"terrains", measures.size()}, {"off", mean.off},     {"estimate", mean.estimate},
                           {"seeds", mean.seeds},         {"drift", mean.drift}, {"change_m", mean.change_m}};
    fmt::print("{}\n", document.dump());
    return;
  }
  fmt::print("{:>8} {:>8} {:>10} {:>9} {:>9} {:>11} {:>7}\n", "cell m", "years", "change m", "network", "estimate",
             "other seed", "drift");
  const auto row = [](const train::ErodeMeasure& m) {
    fmt::print("{:>8.0f} {:>8.0f} {:>10.2f} {:>9.3f} {:>9.3f} {:>11.3f} {:>+7.3f}\n", m.cell_m, m.years, m.change_m,
               m.off, m.estimate, m.seeds, m.drift);
  };
  for (const train::ErodeMeasure& one : measures) row(one);
  fmt::print("mean of {}\n", measures.size());
  row(mean);
}

void add_measure(Command train) {
  const auto flags = std::make_shared<MeasureFlags>();
  Command measure = train.add_command("measure", "How good a network is on ground, or islands, held out of training");
  measure.add("--model", &flags->model, "network: a shipped one by its word, or a file of weights (safetensors)");
  measure.add(
      "--dem", &flags->dem,
      "of a sketch network: folder of elevation models (GeoTIFF); of an erosion network, noise alone if absent");
  measure.add("--count", &flags->count, "pieces of ground, or maps").between(1, 1000);
  measure.add("--size", &flags->size, "cells a side, a power of two from 128 up").between(128, 1024);
  add_run_flags(measure, *flags);
  measure.does([flags] {
    const Session session(*flags);
    const learned::Network network(io::read_weights(io::find_model(flags->model)));
    const Seed seed{flags->seed.value_or(0)};
    if (network.architecture().planes == learned::kIslandPlanes)
      return print_measures(train::measure_islands(network, flags->count, seed, session.run()), flags->json);
    if (network.architecture().planes == learned::kErodePlanes) {
      const std::vector<train::GroundTile> tiles =
          flags->dem.empty() ? std::vector<train::GroundTile>() : train::read_ground(flags->dem, true, session.run());
      return print_measures(train::measure_erosion(network, tiles, flags->count, seed, session.run()), flags->json);
    }
    if (flags->dem.empty()) throw InvalidArgument("--dem", "is missing: the ground to measure on");
    print_measures(train::measure_sketches(network, train::read_ground(flags->dem, true, session.run()),
                                           recipe::draw_again, flags->count, flags->size, seed, session.run()),
                   flags->json);
  });
}

}  // namespace

void add_train_networks(Command command) {
  const auto flags = std::make_shared<TrainFlags>();
  Command sketch = add_kind(command, flags, "sketch", "Ridges, rivers, heights and known ground to terrain");
  sketch.add("--dem", &flags->dem, "folder of elevation models (GeoTIFF)");
  add_set(sketch, flags, "sketches");
  sketch.does([flags] {
    const Session session(*flags);
    if (flags->dem.empty() && flags->set.empty())
      throw InvalidArgument("--dem", "is missing: the ground to learn from, here or in a set of sketches (--set)");
    if (!flags->dem.empty() && !flags->set.empty())
      throw InvalidArgument("--set", "has its own ground: --dem is for samples that are drawn on the fly");
    if (!flags->set.empty()) {
      StoredSketches set = read_stored_sketches(flags->set);
      const Seed seed{flags->seed.value_or(0)};
      return train_on(train::StoredSketchTask(flags->set, set.size, std::move(set.examples), seed), *flags, session);
    }
    const train::SketchTask task(flags->dem, 256, Seed{flags->seed.value_or(0)}, session.run());
    train_on(task, *flags, session);
  });
  add_measure(command);
  Command island = add_kind(command, flags, "island", "Maps of regions to islands, learned from the island generator");
  add_set(island, flags, "islands");
  island.does([flags] {
    const Session session(*flags);
    if (!flags->set.empty()) {
      const StoredIslands set = read_stored_islands(flags->set);
      const Seed seed{flags->seed.value_or(0)};
      return train_on(train::StoredIslandTask(flags->set, set.params, set.count, seed), *flags, session);
    }
    const train::IslandTask task(Seed{flags->seed.value_or(0)});
    train_on(task, *flags, session);
  });
  Command erode = add_kind(command, flags, "erode", "Terrain to eroded terrain, learned from erosion.run");
  erode.add("--dem", &flags->dem, "folder of elevation models (GeoTIFF); noise alone if absent");
  erode.add("--pairs", &flags->pairs, "terrains that are eroded to learn from, 0.5 s each, before the training begins");
  erode.add("--size", &flags->size, "cells of a sample's side: 32, 64 ... 256");
  erode.does([flags] {
    flags->params.emplace("critic_weight", "0");  // what erosion does is known to the metre
    const Session session(*flags);
    const train::ErodeTask task(flags->dem, flags->size, flags->pairs, Seed{flags->seed.value_or(0)}, session.run());
    train_on(task, *flags, session);
  });
}

}  // namespace seamount::app
