// dataset: training pairs on disk.
#include <fmt/format.h>

#include <iostream>

#include "app.h"
#include "seamount/base/printable.h"
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

/// First line of the manifest.
std::string header_line(const train::IslandSetParams& params, uint64_t seed) {
  return Json{{"kind", "islands"}, {"seamount", kVersion}, {"seed", seed}, {"params", recipe::write_params(params)}}
      .dump();
}

std::string sample_line(const train::IslandSample& sample, const train::SampleFiles& files) {
  Json islands = Json::array();
  for (const train::IslandDraw& island : sample.islands) islands.push_back(recipe::write_params(island));
  return Json{{"index", sample.index},
              {"subsidence", sample.subsidence},
              {"labels", fmt::format("{:06}_labels.png", sample.index)},
              {"labels_digest", files.labels_digest},
              {"height", fmt::format("{:06}_height.png", sample.index)},
              {"height_digest", files.height_digest},
              {"islands", islands},
              {"augmentation", recipe::write_params(sample.augmentation)}}
      .dump();
}

/// Reads what sample_line() wrote.
train::SampleRecord read_sample_line(const std::string& line) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) throw Error("is not a JSON object");
  const auto text = [&](const char* name) {
    const auto member = json.find(name);
    if (member == json.end() || !member->is_string()) throw Error("\"" + std::string(name) + "\" is missing");
    return member->get<std::string>();
  };
  const auto index = json.find("index");
  if (index == json.end() || !index->is_number_unsigned()) throw Error("\"index\" is missing");
  train::SampleRecord record{index->get<uint64_t>(), {text("labels_digest"), text("height_digest")}};
  if (text("labels") != fmt::format("{:06}_labels.png", record.index) ||
      text("height") != fmt::format("{:06}_height.png", record.index))
    throw Error("names files of another sample");
  recipe::Diagnostics diagnostics;
  recipe::read_params<train::Augmentation>(json.value("augmentation", Json()), {"/augmentation", diagnostics});
  const Json islands = json.value("islands", Json());
  if (!islands.is_array()) throw Error("\"islands\" is missing");
  for (const Json& island : islands) recipe::read_params<train::IslandDraw>(island, {"/islands", diagnostics});
  if (!diagnostics.empty()) throw Error(diagnostics.items().front().message);
  return record;
}

/// What the samples of a set share.
struct SetOf {
  Json params = Json::object();
  uint64_t seed = 0;
};

/// What the manifest in the folder says, where there is one.
SetOf find_set(const std::string& folder) {
  const std::optional<std::string> header = train::find_set_header(folder);
  if (!header) return {};
  const Json json = Json::parse(*header, nullptr, false);
  const bool known = json.is_object() && json.value("kind", Json()) == "islands" &&
                     json.value("seed", Json()).is_number_unsigned() && json.value("params", Json()).is_object();
  if (!known) throw InvalidArgument("--out", folder + "/manifest.jsonl does not begin with the line of a set");
  return {json["params"], json["seed"].get<uint64_t>()};
}

/// The set's own parameters, else those of the flags. Flags that say something else are found out by the header.
train::IslandSetParams read_set_params(const DatasetFlags& flags, const SetOf& set) {
  Json given = set.params;
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
  const SetOf set = find_set(flags.out);
  const train::IslandSetParams params = read_set_params(flags, set);
  const Seed seed{flags.seed.value_or(set.seed)};
  const std::string header = header_line(params, seed.value);
  const Session session(flags);
  if (flags.only) {
    train::check_set_header(flags.out, header);
    train::IslandSample sample = train::draw_island_sample(params, *flags.only, seed);
    const train::SampleFiles files = train::make_island_files(params, sample, seed, flags.out, session.run());
    std::cout << sample_line(sample, files) << "\n";
    return;
  }
  const train::IslandSetOptions options{flags.out, flags.count, seed, header, sample_line, read_sample_line};
  const train::IslandSetReport report = train::make_island_set(params, options, session.run());
  fmt::print("{}: {} samples made, {} were there\n", printable(flags.out), report.made, report.present);
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
