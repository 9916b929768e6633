#include "seamount/tiles/tiled_import.h"

#include <algorithm>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/large_raster.h"
#include "seamount/recipe/import_params.h"
#include "seamount/recipe/kinds.h"
#include "seamount/tiles/step_params.h"
#include "seamount/tiles/tiled_voids.h"
#include "seamount/tiles/windows.h"

namespace seamount::tiles {
namespace {

bool is_tiff(const std::string& path) {
  const std::string extension = io::extension_of(path);
  return extension == ".tif" || extension == ".tiff";
}

recipe::Call call_of(const World& world, size_t step, const RunContext& run) {
  const recipe::Recipe& recipe = world.recipe();
  return {recipe.domain, recipe.domain_stated, world.step(step).seed, recipe.folder, run};
}

/// Rows of a file in strips are unpacked for each tile beside another: as many tiles at once as memory allows.
int tiles_at_once(const World& world, const Layout& layout) {
  constexpr double kBytes = 16;  // of a cell, while it is read
  int count = layout.columns();
  const auto bytes = [&] { return kBytes * layout.size * layout.size * count; };
  while (count > 1 && !world.fits(bytes(), {layout.size, layout.size})) count = (count + 1) / 2;
  return count;
}

void read_tiles(const io::LargeRaster& file, const StoredRaster& to, int at_once, const RunContext& run) {
  const Layout& layout = to.layout();
  for (int first = 0; first < layout.count();) {
    const int count = std::min(at_once, layout.columns() - first % layout.columns());
    bool there = true;
    Rect all;
    for (int tile = first; tile < first + count; ++tile) {
      there = there && to.has(tile);
      all = united(all, layout.tile(tile));
    }
    if (!there) {
      const GridFrame window = file.frame().window(all.column, all.row, all.width, all.height);
      const auto strip = recipe::Value::of<recipe::kinds::Terrain>(file.read(window, run));
      for (int tile = first; tile < first + count; ++tile) {
        const Rect rect = layout.tile(tile);
        to.write(tile, window_of(strip, {rect.column - all.column, rect.row - all.row, rect.width, rect.height}));
      }
    }
    first += count;
    run.report(static_cast<double>(first) / layout.count());
  }
}

}  // namespace

std::string import_refusal(const recipe::Step& step, const recipe::PlannedStep&) {
  const recipe::ImportParams params = step_params<recipe::ImportParams>(step);
  if (!is_tiff(params.file.path)) return "only a GeoTIFF is read in parts";
  if (params.low_m || params.high_m || params.coding != io::ElevationCoding::numbers)
    return "heights in codes or colours are read as a whole";
  return "";
}

std::optional<GridFrame> import_size(const World& world, size_t step) {
  const recipe::ImportParams params = step_params<recipe::ImportParams>(world.step(step));
  if (!is_tiff(params.file.path)) return std::nullopt;
  const RunContext quiet;
  const auto [width, height] = io::stored_size(call_of(world, step, quiet).resolve(params.file));
  return GridFrame{width, height};
}

void run_tiled_import(World& world, size_t step, const RunContext& run) {
  const recipe::ImportParams params = step_params<recipe::ImportParams>(world.step(step));
  const RunContext looking = run.part(0.0, 0.3);
  const recipe::Call call = call_of(world, step, looking);
  const io::LargeRaster file(call.resolve(params.file), recipe::read_options(params, call, looking));
  const auto stored = world.on_disk({step, "terrain"}, file.frame());
  const auto as_read = params.fill_voids
                           ? world.on_disk_as({step, "terrain-as-read"}, recipe::kinds::Terrain::kind(), file.frame())
                           : stored;
  read_tiles(file, *as_read, tiles_at_once(world, stored->layout()), run.part(0.3, params.fill_voids ? 0.7 : 1.0));
  for (const auto& snapshot : world.plan().steps[step].files) {
    if (snapshot->still_valid()) continue;
    as_read->remove();
    throw IoError(snapshot->path(), "was written to while it was read; run again");
  }
  if (params.fill_voids) {
    if (const int64_t filled = fill_tiled_voids(world, *as_read, *stored, run.part(0.7, 1.0)); filled > 0)
      run.say(recipe::filled_note(filled));
    as_read->remove();
  }
  world.keep_tiles({step, "terrain"}, stored);
}

}  // namespace seamount::tiles
