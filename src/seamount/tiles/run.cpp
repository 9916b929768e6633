#include "seamount/tiles/run.h"

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/geotiff_rows.h"
#include "seamount/io/private_folder.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/output_files.h"
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

std::vector<recipe::OutputReport> write(const World& world, const std::string& out_folder, const RunContext& run) {
  Wholes wholes(world);
  std::mutex one_at_a_time;  // a writer of rows holds some
  const recipe::RowsWriter by_rows = [&](const Output& output, const std::string& path, const io::Provenance& made,
                                         const RunContext& own) {
    const std::lock_guard lock(one_at_a_time);
    if (!goes_by_rows(world, output)) return write_by_windows(world, output, path, made, std::ref(wholes), own);
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

/// The innermost folder above one, which may not be there yet: on its disk there is room for results.
fs::path existing_folder_above(const std::string& folder) {
  fs::path above = fs::absolute(folder).lexically_normal().parent_path();
  while (!fs::is_directory(above) && above.has_relative_path()) above = above.parent_path();
  return above;
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
  std::optional<io::PrivateFolder> temporary;
  if (options.cache_folder.empty()) temporary.emplace(existing_folder_above(options.out_folder));
  const fs::path folder = temporary ? temporary->path() : fs::path(options.cache_folder) / "tiles";
  World world(plan, folder.string(), options);
  std::vector<OutputOf> wanted;
  wanted.reserve(sources.size());
  for (const Source& source : sources) wanted.push_back(world.output_of(source));
  constexpr double kSteps = 0.8;  // of the time, about
  const RunContext first = run.part(0.0, kSteps), second = run.part(kSteps, 1.0);
  StepsRun steps(world, options, first);
  steps.finish(wanted);
  recipe::ExecuteReport report;
  report.steps = steps.reports();
  report.outputs = write(world, options.out_folder, second);
  world.forget_tiles();
  return report;
}

}  // namespace seamount::tiles
