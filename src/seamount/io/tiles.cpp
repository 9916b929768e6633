#include "seamount/io/tiles.h"

#include <algorithm>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/raster_files.h"

namespace seamount::io {
namespace {

void check_side(int samples, int tile_size) {
  const int stride = tile_size - 1;
  if (samples > 1 && (samples - 1) % stride == 0) return;
  const int below = (samples - 1) / stride * stride + 1;
  throw InvalidArgument("tile_size", std::to_string(samples) + " samples are not a whole number of tiles of " +
                                         std::to_string(tile_size) + " that share their borders; " +
                                         (below > 1 ? std::to_string(below) + " or " : "") +
                                         std::to_string(below + stride) + " would be");
}

HeightField cut(const HeightField& heights, int column, int row, int tile_size) {
  GridFrame frame = heights.frame();
  frame.width = frame.height = tile_size;
  frame.west_m += column * frame.cell_m;
  frame.north_m -= row * frame.cell_m;
  HeightField tile(frame);
  for (int y = 0; y < tile_size; ++y) {
    const auto from = heights.row(row + y).subspan(static_cast<size_t>(column), static_cast<size_t>(tile_size));
    std::copy(from.begin(), from.end(), tile.row(y).begin());
  }
  return tile;
}

}  // namespace

std::vector<Tile> write_tiles(const HeightField& heights, const std::string& path, int tile_size,
                              const WriteOptions& options) {
  if (tile_size < 2) throw InvalidArgument("tile_size", std::to_string(tile_size) + " is below 2");
  check_side(heights.width(), tile_size);
  check_side(heights.height(), tile_size);
  WriteOptions shared = options;
  shared.range = coding_range(heights, options.range);
  const std::string extension = extension_of(path);
  const std::string stem = path.substr(0, path.size() - extension.size());
  const int stride = tile_size - 1;
  std::vector<Tile> tiles;
  for (int y = 0; y * stride + 1 < heights.height(); ++y) {
    for (int x = 0; x * stride + 1 < heights.width(); ++x) {
      const std::string file = stem + "_x" + std::to_string(x) + "_y" + std::to_string(y) + extension;
      write_heights(cut(heights, x * stride, y * stride, tile_size), file, shared);
      tiles.push_back({x, y, file});
    }
  }
  return tiles;
}

}  // namespace seamount::io
