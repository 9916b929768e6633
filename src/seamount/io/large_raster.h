// A GeoTIFF of heights that is larger than memory, read window by window: the cells that read_heights() makes of it,
// warped or not.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "seamount/io/read_options.h"
#include "seamount/model/grid.h"

namespace seamount::io {

class LargeRaster {
 public:
  /// Opens the file and looks at every cell once: for codes of cells without a value, for heights that cannot be. Says
  /// and throws what read_heights() does, but for the number of cells, and IoError for what is only read as a whole:
  /// codes of 8 and 16 bits without a unit, files that lie nowhere. REQUIRES: no range, coding nor lattice among the
  /// options. Cost: a read.
  LargeRaster(std::string path, const ReadOptions& options);
  ~LargeRaster();
  LargeRaster(const LargeRaster&) = delete;
  LargeRaster& operator=(const LargeRaster&) = delete;

  /// Of all its heights.
  const GridFrame& frame() const;

  /// The cells of a window of frame(), to the bit. May be called from many threads. Memory: the window, and as much of
  /// the file. Throws IoError, Cancelled.
  HeightField read(const GridFrame& window, const RunContext& run) const;

 private:
  struct File;
  std::unique_ptr<const File> file_;
};

/// Columns and rows that a raster file has as it is stored. Throws IoError.
std::pair<int, int> stored_size(const std::string& path);

}  // namespace seamount::io
