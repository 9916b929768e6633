#include "seamount/io/tiles.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
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
  if (options.last_tiles != LastTiles::by_format) return options.last_tiles == LastTiles::padded;
  const std::string extension = extension_of(path);
  return extension != ".tif" && extension != ".tiff" && extension != ".asc";
}

/// The tile's samples; beyond the terrain its edge is repeated.
HeightField cut(const HeightField& heights, const Tile& tile, int width, int height) {
  GridFrame frame = heights.frame();
  frame.width = width;
  frame.height = height;
  frame.west_m += tile.column * frame.cell_m;
  frame.north_m -= tile.row * frame.cell_m;
  HeightField cells(frame);
  for (int y = 0; y < height; ++y) {
    const auto from = heights.row(tile.row + std::min(y, tile.height - 1))
                          .subspan(static_cast<size_t>(tile.column), static_cast<size_t>(tile.width));
    const auto end = std::copy(from.begin(), from.end(), cells.row(y).begin());
    std::fill(end, cells.row(y).end(), from.back());
  }
  return cells;
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

void write_manifest(const HeightField& heights, const std::string& path, const TileOptions& options, bool padded,
                    const std::vector<Tile>& tiles, const WriteOptions& write) {
  const GridFrame& frame = heights.frame();
  Json json = {{"seamount", "tiles"},      {"width", frame.width},      {"height", frame.height},
               {"cell_m", frame.cell_m},   {"west_m", frame.west_m},    {"north_m", frame.north_m},
               {"east_m", frame.east_m()}, {"south_m", frame.south_m()}};
  if (!frame.crs.empty()) json["crs"] = frame.crs;
  json["tile_size"] = options.tile_size;
  json["last_tiles"] = padded ? "padded" : "smaller";
  json["share_border"] = options.share_border;
  json["columns"] = tiles.back().x + 1;
  json["rows"] = tiles.back().y + 1;
  const std::string extension = extension_of(path);
  if (write.range && (extension == ".png" || extension == ".r16" || extension == ".raw")) {
    json["low_m"] = write.range->low_m;
    json["high_m"] = write.range->high_m;
  }
  json["tiles"] = Json::array();
  for (const Tile& tile : tiles) {
    json["tiles"].push_back({{"file", file_name(tile.path)},
                             {"x", tile.x},
                             {"y", tile.y},
                             {"column", tile.column},
                             {"row", tile.row},
                             {"width", tile.width},
                             {"height", tile.height}});
  }
  write_text(tiles_manifest(path), json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string metres(double from, double to) {
  const auto shown = [](double value) { return format_number(std::round(value * 100) / 100 + 0.0); };
  return shown(from) + " to " + shown(to) + " m";
}

void tell(const HeightField& heights, const std::string& path, const Cuts& across, const Cuts& down, bool padded,
          const RunContext& run) {
  const GridFrame& frame = heights.frame();
  const std::string count = std::to_string(across.count()) + " x " + std::to_string(down.count());
  run.say(count + " tiles cover x " + metres(frame.west_m, frame.east_m()) + " and y " +
          metres(frame.south_m(), frame.north_m) + "; " + file_name(tiles_manifest(path)) + " lists them");
  if (across.padding() + down.padding() == 0) return;
  const std::string last = "the last tiles in the east have " + std::to_string(across.length(across.count() - 1)) +
                           " columns of ground and those in the south " +
                           std::to_string(down.length(down.count() - 1)) + " rows, of " +
                           std::to_string(across.tile_size);
  run.say(last + (padded ? "; the rest of them repeats the terrain's edge" : ": they are smaller files"));
}

}  // namespace

std::string tiles_manifest(const std::string& path) { return stem_of(path) + "_tiles.json"; }

std::vector<Tile> write_tiles(const HeightField& heights, const std::string& path, const TileOptions& options,
                              const WriteOptions& write, const RunContext& run) {
  const int size = options.tile_size;
  if (size < 2) throw InvalidArgument("tile_size", std::to_string(size) + " is below 2");
  if (heights.empty()) throw InvalidArgument("heights", "there are no cells");
  const std::string extension = extension_of(path);
  WriteOptions shared = write;
  if (extension == ".png" || extension == ".r16" || extension == ".raw")
    shared.range = coding_range(heights, write.range);
  const bool padded = pads(options, path);
  const int stride = options.share_border ? size - 1 : size;
  const Cuts across{stride, size, heights.width()}, down{stride, size, heights.height()};
  std::vector<Tile> tiles;
  for (int y = 0; y < down.count(); ++y) {
    for (int x = 0; x < across.count(); ++x) {
      run.check_cancelled();
      const Tile tile{x,
                      y,
                      stem_of(path) + "_x" + std::to_string(x) + "_y" + std::to_string(y) + extension,
                      across.begin(x),
                      down.begin(y),
                      across.length(x),
                      down.length(y)};
      const bool whole = tile.width == size && tile.height == size;
      shared.ground_width = padded && !whole ? tile.width : 0;
      shared.ground_height = padded && !whole ? tile.height : 0;
      write_heights(cut(heights, tile, padded ? size : tile.width, padded ? size : tile.height), tile.path, shared);
      tiles.push_back(tile);
      run.report(static_cast<double>(tiles.size()) / (1.0 * across.count() * down.count()));
    }
  }
  write_manifest(heights, path, options, padded, tiles, shared);
  tell(heights, path, across, down, padded, run);
  return tiles;
}

}  // namespace seamount::io
