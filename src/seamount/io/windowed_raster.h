// Rasters that need not be in memory as a whole, and how they are read: once, in large pieces.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/io/sidecar.h"
#include "seamount/model/grid.h"

namespace seamount::io {

struct WindowedRaster {
  GridFrame frame;
  /// `width` x `height` of its cells from (column, row) on, on a window of its frame.
  std::function<Grid<float>(int column, int row, int width, int height)> window;
  bool heights = true;  ///< metres above sea level; else any other scalar
};

/// REQUIRES: the raster outlives it.
WindowedRaster windows_of(const Grid<float>& raster, bool heights = true);

/// What is known of a raster without its cells being kept.
struct RasterExtremes {
  HeightRange range;        ///< of the known cells
  int64_t known_cells = 0;  ///< 0: `range` says nothing
  int64_t unknown_cells = 0;
};

/// Reads all cells once. Throws InvalidArgument{"heights"} for an infinite one. Memory: 64 rows.
RasterExtremes extremes_of(const WindowedRaster& raster, const RunContext& run);

/// Cells of a raster.
struct CellWindow {
  int column = 0, row = 0, width = 0, height = 0;
};

/// Calls visit(i, cells of windows[i]) for all of them, many at once. Windows that follow each other with the same rows
/// are read together, as long as that is less than 256 MB: what a raster is stored in may be larger than they are.
void for_each_window(const WindowedRaster& raster, const std::vector<CellWindow>& windows, const RunContext& run,
                     const std::function<void(size_t index, const Grid<float>& cells)>& visit);

}  // namespace seamount::io
