#include "seamount/tiles/run.h"

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>

#include "seamount/base/error.h"
#include "seamount/base/hash.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/geotiff_rows.h"
#include "seamount/io/private_folder.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/output_files.h"
#include "seamount/tiles/spread_outputs.h"
#include "seamount/tiles/steps_run.h"
#include "seamount/tiles/windowed_outputs.h"
#include "seamount/tiles/windows.h"

namespace seamount::tiles {
namespace {

namespace fs = std::filesystem;
using recipe::Output, recipe::Source;

/// A raster that is written to a GeoTIFF: that is done row by row.
bool goes_by_rows(const World& world, const Output& output) {
  const OutputOf from = world.output_of(output.from);
  const recipe::Kind& kind = *world.step(from.first).op->find_out(from.second)->kind;
  const std::string extension = io::extension_of(output.path);
  return (extension == ".tif" || extension == ".tiff") && is_raster(kind) &&
         (output.format->name == "raster" || output.format->name == "labels");
}

io::CellMeaning meaning_of(const recipe::Kind& kind) {
  if (&kind == &recipe::kinds::Labels::kind()) return io::CellMeaning::regions;
  return &kind == &recipe::kinds::Terrain::kind() ? io::CellMeaning::heights : io::CellMeaning::field;
}

void write_rows(const World& world, const Output& output, const std::string& path, const io::Provenance& provenance,
                const RunContext& run) {
  const OutputOf from = world.output_of(output.from);
  const recipe::Kind& kind = *world.step(from.first).op->find_out(from.second)->kind;
  const bool for_network = output.params.value("cloud_optimised", false);
  io::write_geotiff_rows(
      world.frame(from), meaning_of(kind),
      [&](int first, int count, void* cells) { world.rows(from, first, count, cells); }, path, provenance, for_network,
      run);
}

/// Values of outputs that are written as a whole, each fetched once; a value of rows is never asked for.
class Wholes {
 public:
  explicit Wholes(const World& world) : world_(world) {}
  const recipe::Value& operator()(const Source& source) {
    const std::lock_guard lock(mutex_);
    const auto found = values_.find(source);
    if (found != values_.end()) return found->second;
    return values_.emplace(source, world_.whole(world_.output_of(source))).first->second;
  }

 private:
  const World& world_;
  std::mutex mutex_;
  std::map<Source, recipe::Value> values_;
};

std::vector<recipe::OutputReport> write(const World& world, const std::string& out_folder, const SpreadOutputs* written,
                                        const RunContext& run) {
  Wholes wholes(world);
  std::mutex one_at_a_time;  // a writer of rows holds some
  const recipe::RowsWriter by_rows = [&](const Output& output, const std::string& path, const io::Provenance& made,
                                         const RunContext& own) {
    const bool rows = goes_by_rows(world, output);
    if (rows && written != nullptr) return written->move_to(output, path);
    const std::lock_guard lock(one_at_a_time);
    if (!rows) return write_by_windows(world, output, path, made, std::ref(wholes), own);
    write_rows(world, output, path, made, own);
    return true;
  };
  return recipe::write_outputs(
      world.recipe(), out_folder, [&](const Source& source) -> const recipe::Value& { return wholes(source); },
      [&](size_t) {
        RunContext own = run;
        own.progress = nullptr;
        return own;
      },
      run, by_rows);
}

/// Ranks that see other files, or are of another version, would make tiles of another world.
void check_same_plan(const recipe::Plan& plan, Ranks& ranks) {
  Hasher all;
  for (const recipe::PlannedStep& step : plan.steps)
    if (step.needed && !step.defect) all.text(step.key.hex());
  const std::string mine = all.digest().hex();
  if (ranks.share(mine) != mine)
    throw Error(
        "what the recipe makes is not the same for all ranks: do they see the same files, and are they of one version "
        "of Seamount?");
}

/// The innermost folder above one, which may not be there yet: on its disk there is room for results.
fs::path existing_folder_above(const std::string& folder) {
  fs::path above = fs::absolute(folder).lexically_normal().parent_path();
  while (!fs::is_directory(above) && above.has_relative_path()) above = above.parent_path();
  return above;
}

/// The rasters among the outputs, where there are ranks to share them.
std::optional<SpreadOutputs> written_side_by_side(const World& world, const std::string& out_folder,
                                                  const RunContext& run) {
  if (world.ranks().size() == 1) return std::nullopt;
  std::vector<const Output*> rasters;
  for (const Output& output : world.recipe().outputs)
    if (goes_by_rows(world, output)) rasters.push_back(&output);
  const io::Provenance made = recipe::provenance_of(world.recipe());
  const auto write = [&](const Output& output, const std::string& path, const RunContext& own) {
    write_rows(world, output, path, made, own);
  };
  return std::optional<SpreadOutputs>(std::in_place, world.ranks(), existing_folder_above(out_folder).string(),
                                      out_folder, rasters, write, run);
}

}  // namespace

recipe::ExecuteReport execute(const recipe::Recipe& recipe, const TileOptions& options, const RunContext& run) {
  if (options.tile < 1) throw InvalidArgument("tiles", "a tile has at least one cell");
  recipe::check_nothing_overwritten(recipe, options.out_folder);
  for (const recipe::Diagnostic& note : recipe.notes) run.say(recipe::diagnostic_line(recipe.file, note));
  std::vector<Source> sources = recipe::output_sources(recipe);
  if (sources.empty()) throw Error("the recipe has no output: there is nothing to make in tiles");
  recipe::FileSnapshots files;
  const recipe::Plan plan = recipe::make_plan(
      std::shared_ptr<const recipe::Recipe>(std::shared_ptr<const recipe::Recipe>(), &recipe), sources, files);
  const std::unique_ptr<Ranks> alone = options.ranks == nullptr ? one_rank() : nullptr;
  Ranks& ranks = alone ? *alone : *options.ranks;
  check_same_plan(plan, ranks);
  std::optional<io::PrivateFolder> temporary;
  if (options.cache_folder.empty() && ranks.first()) temporary.emplace(existing_folder_above(options.out_folder));
  const fs::path folder = options.cache_folder.empty() ? fs::path(ranks.share(temporary ? temporary->path() : ""))
                                                       : fs::path(options.cache_folder) / "tiles";
  World world(plan, folder.string(), options, ranks);
  std::vector<OutputOf> wanted;
  wanted.reserve(sources.size());
  for (const Source& source : sources) wanted.push_back(world.output_of(source));
  constexpr double kSteps = 0.8;  // of the time, about
  const RunContext first = run.part(0.0, kSteps), second = run.part(kSteps, 1.0);
  StepsRun steps(world, options, first);
  steps.finish(wanted);
  recipe::ExecuteReport report;
  report.steps = steps.reports();
  const auto written = written_side_by_side(world, options.out_folder, second);
  by_first(ranks, [&] { report.outputs = write(world, options.out_folder, written ? &*written : nullptr, second); });
  for (size_t i = 0; written && i < report.outputs.size(); ++i)
    report.outputs[i].seconds += written->seconds(recipe.outputs[i]);
  world.forget_tiles();
  return report;
}

}  // namespace seamount::tiles
