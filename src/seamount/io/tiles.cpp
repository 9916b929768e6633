#include "seamount/io/tiles.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/engine_tiles.h"
#include "seamount/io/raster_files.h"

namespace seamount::io {
namespace {

using Json = nlohmann::ordered_json;

/// Where the tiles of one direction begin and how many samples of the terrain each has.
struct Cuts {
  int stride, tile_size, samples;

  int count() const {
    const int shared = tile_size - stride;
    return std::max(1, (samples - shared + stride - 1) / stride);
  }
  int begin(int tile) const { return tile * stride; }
  int length(int tile) const { return std::min(tile_size, samples - begin(tile)); }
  int padding() const { return begin(count() - 1) + tile_size - samples; }
};

std::string stem_of(const std::string& path) { return path.substr(0, path.size() - extension_of(path).size()); }

bool pads(const TileOptions& options, const std::string& path) {
  if (options.engine) return true;
  if (options.last_tiles != LastTiles::by_format) return options.last_tiles == LastTiles::padded;
  const std::string extension = extension_of(path);
  return extension != ".tif" && extension != ".tiff" && extension != ".asc";
}

bool is_integer(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".png" || extension == ".r16" || extension == ".raw";
}

/// The frame of a tile of so many samples.
GridFrame tile_frame(const GridFrame& whole, const Tile& tile, int width, int height) {
  GridFrame frame = whole;
  frame.cut = {};
  frame.width = width;
  frame.height = height;
  frame.west_m += tile.column * frame.cell_m;
  frame.north_m -= tile.row * frame.cell_m;
  return frame;
}

/// The tile's samples; beyond the terrain its edge is repeated.
Grid<float> filled(const Grid<float>& ground, const GridFrame& whole, const Tile& tile, int width, int height) {
  Grid<float> cells(tile_frame(whole, tile, width, height));
  for (int y = 0; y < height; ++y) {
    const auto from = ground.row(std::min(y, tile.height - 1));
    const auto end = std::copy(from.begin(), from.end(), cells.row(y).begin());
    std::fill(end, cells.row(y).end(), from.back());
  }
  return cells;
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

/// One call of write_tiles(), as far as it is the same for all tiles.
struct Plan {
  const WindowedRaster& raster;
  std::string path;
  TileOptions options;
  WriteOptions write;
  Cuts across, down;
  bool padded = false;
  std::optional<Sidecar> engine_numbers = {};  ///< of heights for an engine

  Tile tile(int x, int y) const {
    return {x,
            y,
            stem_of(path) + tile_suffix(options.engine, x, y, down.count()) + extension_of(path),
            across.begin(x),
            down.begin(y),
            across.length(x),
            down.length(y)};
  }
  std::optional<HeightRange> range() const { return engine_numbers ? engine_numbers->range : write.range; }
};

Json manifest_of_tile(const Plan& plan, const Tile& tile) {
  Json json = {{"file", file_name(tile.path)}, {"x", tile.x},     {"y", tile.y},
               {"column", tile.column},        {"row", tile.row}, {"width", tile.width},
               {"height", tile.height}};
  if (!plan.options.engine) return json;
  for (const auto& [name, value] : tile_place(tile, plan.across.count(), plan.down.count(), plan.raster.frame,
                                              plan.options, plan.range().value_or(HeightRange{})))
    json["place"][name] = value;
  return json;
}

void write_manifest(const Plan& plan, const std::vector<Tile>& tiles) {
  const GridFrame& frame = plan.raster.frame;
  Json json = {{"seamount", "tiles"},      {"width", frame.width},      {"height", frame.height},
               {"cell_m", frame.cell_m},   {"west_m", frame.west_m},    {"north_m", frame.north_m},
               {"east_m", frame.east_m()}, {"south_m", frame.south_m()}};
  if (!frame.crs.empty()) json["crs"] = frame.crs;
  json["tile_size"] = plan.options.tile_size;
  json["last_tiles"] = plan.padded ? "padded" : "smaller";
  json["share_border"] = plan.options.share_border;
  json["columns"] = plan.across.count();
  json["rows"] = plan.down.count();
  if (const auto range = plan.range(); range && is_integer(plan.path))
    json["low_m"] = range->low_m, json["high_m"] = range->high_m;
  if (plan.options.engine) json["engine"] = Choices<Engine>::names[static_cast<size_t>(*plan.options.engine)];
  if (plan.engine_numbers) {
    json["first_row"] = plan.engine_numbers->south_first ? "south" : "north";
    for (const auto& [name, value] : plan.engine_numbers->import) json["numbers"][name] = value;
  }
  json["tiles"] = Json::array();
  for (const Tile& tile : tiles) json["tiles"].push_back(manifest_of_tile(plan, tile));
  write_text(tiles_manifest(plan.path), json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string metres(double from, double to) {
  const auto shown = [](double value) { return format_number(std::round(value * 100) / 100 + 0.0); };
  return shown(from) + " to " + shown(to) + " m";
}

void tell(const Plan& plan, const RunContext& run) {
  const GridFrame& frame = plan.raster.frame;
  const Cuts &across = plan.across, &down = plan.down;
  const std::string count = std::to_string(across.count()) + " x " + std::to_string(down.count());
  run.say(count + " tiles cover x " + metres(frame.west_m, frame.east_m()) + " and y " +
          metres(frame.south_m(), frame.north_m) + "; " + file_name(tiles_manifest(plan.path)) + " lists them" +
          (plan.engine_numbers ? " with the numbers to type in" : ""));
  if (plan.options.engine == Engine::unreal && confuses_unreal(plan.path))
    run.say("Unreal takes digits after x, y, u or v in a name for a tile's number: give the files another name than '" +
            std::filesystem::path(plan.path).stem().string() + "'");
  if (across.padding() + down.padding() == 0) return;
  const std::string last = "the last tiles in the east have " + std::to_string(across.length(across.count() - 1)) +
                           " columns of ground and those in the south " +
                           std::to_string(down.length(down.count() - 1)) + " rows, of " +
                           std::to_string(across.tile_size);
  std::string rest = plan.padded ? "; the rest of them repeats the terrain's edge" : ": they are smaller files";
  if (plan.options.engine)
    rest += "; a terrain of " + std::to_string(frame.width + across.padding()) + " x " +
            std::to_string(frame.height + down.padding()) + " cells would fill them";
  run.say(last + rest);
}

HeightRange range_to_code(const RasterExtremes& extremes) {
  const HeightRange range = extremes.range;
  return range.high_m - range.low_m < 1.0 ? HeightRange{range.low_m - 0.5, range.high_m + 0.5} : range;
}

void check_mask(const RasterExtremes& extremes) {
  if (extremes.range.low_m < 0.0 || extremes.range.high_m > 1.0)
    throw InvalidArgument("field", "its values from " + format_number(extremes.range.low_m) + " to " +
                                       format_number(extremes.range.high_m) +
                                       " are no mask from 0 to 1: make one of it, or leave engine away");
}

/// Settles what all tiles share: one range, and what the engine is told.
void settle_range(Plan& plan, const std::optional<RasterExtremes>& known, const RunContext& run) {
  const bool integer = is_integer(plan.path);
  if (!plan.options.engine && (!integer || plan.write.range)) {
    if (integer) coding_range(Grid<float>(GridFrame{1, 1}, 0.0F), plan.write.range);  // checks it
    return;
  }
  const RasterExtremes extremes = known ? *known : extremes_of(plan.raster, run);
  if (extremes.known_cells == 0) throw InvalidArgument("heights", "none of the cells has a value");
  if (extremes.unknown_cells > 0 && !can_hold_voids(plan.path))
    throw InvalidArgument("heights", std::to_string(extremes.unknown_cells) + " cells have no value to write");
  if (!plan.options.engine) {
    plan.write.range = range_to_code(extremes);
  } else if (!plan.raster.heights) {
    check_mask(extremes);
    plan.write.range.reset();
  } else {
    GridFrame samples = plan.raster.frame;
    samples.width = samples.height = plan.options.tile_size;
    plan.engine_numbers = engine_sidecar(samples, extremes.range, *plan.options.engine, plan.path,
                                         {.range = plan.write.range, .provenance = plan.write.provenance});
  }
}

void write_one(const Plan& plan, const Tile& tile, const Grid<float>& ground) {
  const int size = plan.options.tile_size;
  const bool whole = tile.width == size && tile.height == size;
  const Grid<float> cells =
      filled(ground, plan.raster.frame, tile, plan.padded ? size : tile.width, plan.padded ? size : tile.height);
  WriteOptions write = plan.write;
  write.ground_width = plan.padded && !whole ? tile.width : 0;
  write.ground_height = plan.padded && !whole ? tile.height : 0;
  if (plan.options.engine && !plan.raster.heights) return write_mask(cells, tile.path, write);
  if (!plan.engine_numbers)
    return plan.raster.heights ? write_heights(cells, tile.path, write) : write_field(cells, tile.path, write);
  Sidecar sidecar = *plan.engine_numbers;
  const HeightRange extremes = known_range(cells);
  sidecar.frame = cells.frame();
  sidecar.min_m = extremes.low_m;
  sidecar.max_m = extremes.high_m;
  sidecar.ground_width = write.ground_width;
  sidecar.ground_height = write.ground_height;
  for (const ImportNumber& number : tile_place(tile, plan.across.count(), plan.down.count(), plan.raster.frame,
                                               plan.options, sidecar.range.value_or(HeightRange{})))
    sidecar.import.push_back(number);
  write_engine_samples(cells, *plan.options.engine, sidecar, tile.path);
}

}  // namespace

std::string tiles_manifest(const std::string& path) { return stem_of(path) + "_tiles.json"; }

std::string tiles_pattern(const std::string& path, std::optional<Engine> engine) {
  return stem_of(path) + (engine == Engine::unity ? "_*_*" : "_x*_y*") + extension_of(path);
}

std::vector<Tile> write_tiles(const WindowedRaster& raster, const std::string& path, const TileOptions& options,
                              const WriteOptions& write, const RunContext& run,
                              const std::optional<RasterExtremes>& extremes) {
  const int size = options.tile_size;
  if (size < 2) throw InvalidArgument("tile_size", std::to_string(size) + " is below 2");
  if (raster.frame.cells() == 0) throw InvalidArgument("heights", "there are no cells");
  check_engine_tiles(options);
  if (options.engine) check_engine_path(path, *options.engine, raster.heights);
  const int stride = options.share_border ? size - 1 : size;
  Plan plan{.raster = raster,
            .path = path,
            .options = options,
            .write = write,
            .across = {stride, size, raster.frame.width},
            .down = {stride, size, raster.frame.height},
            .padded = pads(options, path)};
  settle_range(plan, extremes, run.part(0.0, 0.2));
  std::vector<Tile> tiles;
  std::vector<CellWindow> windows;
  for (int y = 0; y < plan.down.count(); ++y) {
    for (int x = 0; x < plan.across.count(); ++x) {
      tiles.push_back(plan.tile(x, y));
      const Tile& tile = tiles.back();
      windows.push_back({tile.column, tile.row, tile.width, tile.height});
    }
  }
  for_each_window(raster, windows, run.part(0.2, 1.0),
                  [&](size_t i, const Grid<float>& cells) { write_one(plan, tiles[i], cells); });
  write_manifest(plan, tiles);
  tell(plan, run);
  return tiles;
}

std::vector<Tile> write_tiles(const HeightField& heights, const std::string& path, const TileOptions& options,
                              const WriteOptions& write, const RunContext& run) {
  return write_tiles(windows_of(heights), path, options, write, run);
}

}  // namespace seamount::io
