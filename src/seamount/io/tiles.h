// Worlds larger than one image, as tiles, for GIS and for engines that load a world piece by piece.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/io/engine.h"
#include "seamount/io/raster.h"
#include "seamount/io/windowed_raster.h"
#include "seamount/model/grid.h"

namespace seamount::io {

/// What becomes of the last tiles where a terrain is not a whole number of tiles: as large as the others, its edge
/// repeated beyond it, or as small as what is left. by_format: smaller in files that know their place (.tif, .asc),
/// padded in all others, whose readers want tiles of one size.
enum class LastTiles { by_format, padded, smaller };

struct TileOptions {
  int tile_size = 1025;  ///< samples a side, >= 2
  LastTiles last_tiles = LastTiles::by_format;
  bool share_border = true;  ///< the last row or column of a tile is the first of the next one
  /// The tiles are what this engine reads: sizes, codes, row order, names. Last tiles are padded.
  std::optional<Engine> engine;
};

/// One tile: the terrain's samples from (column, row) on, `width` x `height` of them. A padded file is larger.
struct Tile {
  int x = 0;  ///< from the west
  int y = 0;  ///< from the NORTH
  std::string path;
  int column = 0, row = 0;
  int width = 0, height = 0;
};

/// "name_tiles.json" of "name.ext".
std::string tiles_manifest(const std::string& path);

/// The names of all tiles of "name.ext", '*' for digits: "name_x*_y*.ext", for Unity "name_*_*.ext".
std::string tiles_pattern(const std::string& path, std::optional<Engine> engine);

/// Cuts a raster into tiles with its own cells, from the north-west corner on, and writes each with write_heights() or
/// write_field() as "name_x0_y0.ext" for path "name.ext", with its place; for an engine as write_for_engine() does
/// (named as engine_tiles.h says), and fields as masks of 8 bits. Every sample is in the tiles; integer tiles share one
/// range (that of the whole raster unless `write.range` is set). tiles_manifest(path) says the whole extent, of each
/// tile its file and which samples it holds, and what to type into the engine. Says the extent, and what was padded.
/// `extremes`: of the raster, if they are known already. Throws InvalidArgument{"tile_size"} for a tile_size below 2 or
/// that the engine does not read, {"last_tiles"}, {"path"}, {"heights"} for unknown cells that a format cannot hold,
/// {"field"} for one that is no mask. Parallel. Memory: 256 MB or a tile, and
/// a tile for each thread.
std::vector<Tile> write_tiles(const WindowedRaster& raster, const std::string& path, const TileOptions& options = {},
                              const WriteOptions& write = {}, const RunContext& run = {},
                              const std::optional<RasterExtremes>& extremes = {});
std::vector<Tile> write_tiles(const HeightField& heights, const std::string& path, const TileOptions& options = {},
                              const WriteOptions& write = {}, const RunContext& run = {});

}  // namespace seamount::io

template <>
struct seamount::Choices<seamount::io::LastTiles> {
  static constexpr std::array<std::string_view, 3> names = {"by_format", "padded", "smaller"};
};
