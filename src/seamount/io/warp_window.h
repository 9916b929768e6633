// A part of a raster that is warped to metres, from a source that is read part by part: the bits of warp_to_metres().
// Not part of the public interface.
#pragma once

#include <functional>

#include "seamount/base/run_context.h"
#include "seamount/io/placement.h"
#include "seamount/model/grid.h"

namespace seamount::io {

/// The source: how it lies, its size, and its cells from (column, row) on.
struct WarpSource {
  const Placement& placement;
  int width = 0, height = 0;
  std::function<Grid<float>(int column, int row, int width, int height)> read;
};

/// The window `window` of a warped raster. Memory: the window, and what of the source lies under 64 of its rows.
/// Throws IoError through `call`, what read() throws, Cancelled.
Grid<float> warp_window(const GridFrame& window, const WarpSource& source, const GdalCall& call, const RunContext& run);

}  // namespace seamount::io
