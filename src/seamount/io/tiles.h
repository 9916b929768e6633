// Worlds larger than one image, as tiles that share their border samples.
#pragma once

#include <string>
#include <vector>

#include "seamount/io/raster.h"
#include "seamount/model/grid.h"

namespace seamount::io {

struct Tile {
  int x = 0;  ///< from the west
  int y = 0;  ///< from the NORTH
  std::string path;
};

/// Cuts a terrain into tiles of tile_size x tile_size samples, neighbours sharing one row or column, and writes each
/// with write_heights() as "name_x0_y0.ext" for path "name.ext". 16-bit tiles share one range (that of the whole
/// terrain unless options.range is set). Throws InvalidArgument{"tile_size"} unless (width - 1) and (height - 1) are
/// multiples of (tile_size - 1).
std::vector<Tile> write_tiles(const HeightField& heights, const std::string& path, int tile_size,
                              const WriteOptions& options = {});

}  // namespace seamount::io
