// train dictionary: atoms for amplify.sparse from elevation models, and how good they are.
#include <fmt/format.h>

#include <iostream>

#include "seamount/base/printable.h"
#include "seamount/base/version.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/solve/fill_voids.h"
#include "seamount/io/find_model.h"
#include "seamount/io/weights.h"
#include "seamount/ops/amplify/sparse.h"
#include "seamount/recipe/dictionary_file.h"
#include "seamount/train/detail_measures.h"
#include "seamount/train/dictionary.h"
#include "seamount/train/ground_tiles.h"
#include "train_command.h"

namespace seamount::app {
namespace {

using recipe::Json;

struct DictionaryFlags : RunFlags {
  std::string dem, out, check;
  std::string tiles, held_out;
  std::map<std::string, std::string> params;
};

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  for (size_t begin = 0; begin < text.size();) {
    const size_t comma = std::min(text.find(',', begin), text.size());
    if (comma > begin) parts.push_back(text.substr(begin, comma - begin));
    begin = comma + 1;
  }
  return parts;
}

train::DictionaryParams read_dictionary_params(const DictionaryFlags& flags) {
  Json given = Json::object();
  for (const recipe::ParamInfo& info : recipe::describe_params<train::DictionaryParams>()) {
    const auto found = flags.params.find(info.name);
    if (found != flags.params.end()) given[info.name] = recipe::parse_flag(info, found->second);
  }
  recipe::Diagnostics diagnostics;
  const auto params = recipe::read_params<train::DictionaryParams>(given, {"", diagnostics});
  if (!diagnostics.empty()) throw_as_flag(diagnostics.items().front(), "train dictionary", {{"/", "--"}});
  return params;
}

std::string names_of(const std::vector<train::GroundTile>& tiles) {
  std::string names;
  for (const train::GroundTile& tile : tiles) names += (names.empty() ? "" : ", ") + tile.name;
  return names;
}

void print_row(const char* name, const std::vector<double>& values, int digits) {
  fmt::print("  {:38}", name);
  for (const double value : values) fmt::print(" {:>10.{}f}", value, digits);
  fmt::print("\n");
}

/// A held-out tile coarsened by four and amplified again, beside bicubic interpolation of the same.
void print_measures(const train::GroundTile& tile, const amplify::Dictionary& dictionary, const RunContext& run) {
  constexpr int kFactor = 4;
  HeightField real = tile.heights;
  GridFrame frame = real.frame();
  frame.width = frame.width / kFactor * kFactor;
  frame.height = frame.height / kFactor * kFactor;
  constexpr int kLeast = 64;
  if (frame.width < kLeast || frame.height < kLeast) return;
  geom::fill_voids(real, run.part(0.0, 0.1));
  real = geom::resample(real, frame, run.part(0.1, 0.15));
  const HeightField coarse = geom::box_downsample(real, kFactor, run.part(0.15, 0.2));
  const HeightField made = amplify::sparse(coarse, dictionary, {}, run.part(0.2, 0.8));
  const HeightField bicubic = geom::resample(coarse, frame, run.part(0.8, 0.9));
  std::vector<train::DetailMeasures> all;
  for (const HeightField* terrain : std::initializer_list<const HeightField*>{&real, &made, &bicubic})
    all.push_back(train::measure_detail(*terrain, real, kFactor, run.part(0.9, 1.0)));
  const auto row = [&](const char* name, int digits, auto value) {
    std::vector<double> values;
    for (const train::DetailMeasures& measures : all) values.push_back(value(measures));
    print_row(name, values, digits);
  };
  fmt::print("{}: {} x {} cells of {:.1f} m\n  {:38} {:>10} {:>10} {:>10}\n", printable(tile.name), frame.width,
             frame.height, frame.cell_m, "", "real", "amplified", "bicubic");
  for (int o = 0; o < train::kOctaves; ++o) {
    row(fmt::format("power of {} to {} cells, share of real", 2 << o, 4 << o).c_str(), 2,
        [&](const train::DetailMeasures& m) { return m.octaves[o] / all[0].octaves[o]; });
  }
  row("mean slope, degrees", 2, [](const train::DetailMeasures& m) { return m.slope_deg; });
  row("slopes off, degrees", 2, [](const train::DetailMeasures& m) { return m.slope_off_deg; });
  row("heights off (rms), m", 2, [](const train::DetailMeasures& m) { return m.rms_m; });
  row("pits for each km2", 2, [](const train::DetailMeasures& m) { return m.pits_km2; });
  row("jumps of slope at seams", 3, [](const train::DetailMeasures& m) { return m.seams; });
}

/// What the file says of itself.
void describe(Weights& weights, const train::ChosenGround& tiles, const train::DictionaryParams& params,
              uint64_t seed) {
  weights.about["tiles"] = names_of(tiles.learned);
  weights.about["held_out"] = names_of(tiles.held_out);
  weights.about["params"] = recipe::write_params(params).dump();
  weights.about["seed"] = std::to_string(seed);
  weights.about["seamount"] = kVersion;
}

amplify::Dictionary make(const DictionaryFlags& flags, const train::ChosenGround& tiles, const RunContext& run) {
  const train::DictionaryParams params = read_dictionary_params(flags);
  std::vector<HeightField> grounds;
  for (const train::GroundTile& tile : tiles.learned) grounds.push_back(tile.heights);
  const uint64_t seed = flags.seed.value_or(0);
  const train::LearnedDictionary learned = train::learn_dictionary(grounds, params, Seed{seed}, run);
  Weights weights = amplify::weights_of(learned.dictionary);
  describe(weights, tiles, params, seed);
  io::write_weights(weights, flags.out, io::WeightType::f16);
  fmt::print("{}: {} atoms of {} pieces, details times {:.2f}\n", printable(flags.out),
             learned.dictionary.shapes.size(), learned.pieces, learned.scale);
  return recipe::read_dictionary(flags.out);
}

void train_dictionary(const DictionaryFlags& flags) {
  if (flags.dem.empty()) throw InvalidArgument("--dem", "a folder name is needed");
  if (flags.out.empty() == flags.check.empty())
    throw InvalidArgument("--out", "a file to write, or --check and one to measure: one of both is needed");
  read_dictionary_params(flags);
  const Session session(flags);
  const train::ChosenGround tiles =
      train::read_chosen_ground(flags.dem, split(flags.tiles), split(flags.held_out), session.run().part(0.0, 0.3));
  fmt::print("learned from: {}\nheld out: {}\n", printable(names_of(tiles.learned)),
             printable(names_of(tiles.held_out)));
  const amplify::Dictionary dictionary = flags.check.empty() ? make(flags, tiles, session.run().part(0.3, 0.7))
                                                             : recipe::read_dictionary(io::find_model(flags.check));
  for (const train::GroundTile& tile : tiles.held_out) print_measures(tile, dictionary, session.run().part(0.7, 1.0));
}

}  // namespace

void add_train_dictionary(Command train) {
  const auto flags = std::make_shared<DictionaryFlags>();
  Command command = train.add_command(
      "dictionary", "Atoms of real ground for amplify.sparse; measures them on elevation models that are held out");
  command.add("--dem", &flags->dem, "folder of elevation models: GeoTIFF, HGT").required();
  command.add("--out", &flags->out, "file of the dictionary: .safetensors");
  command.add("--check", &flags->check, "measure this dictionary (a file, or mountains, hills, canyons) instead");
  command.add("--tiles", &flags->tiles, "beginnings of the names of those to learn from: alps,crop_n39; else all");
  command.add("--held-out,--held_out", &flags->held_out,
              "beginnings of the names of those to measure by; else the southern fifth of each");
  add_run_flags(command, *flags);
  for (const recipe::ParamInfo& info : recipe::describe_params<train::DictionaryParams>()) {
    command
        .add(
            "--" + info.name, [flags, name = info.name](const std::string& text) { flags->params[name] = text; },
            info.help + (info.unit.empty() ? "" : " [" + info.unit + "]"))
        .kind(info.kind);
  }
  command.does([flags] { train_dictionary(*flags); });
}

}  // namespace seamount::app
