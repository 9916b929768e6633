#include "seamount/io/windowed_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"

namespace seamount::io {
namespace {

Grid<float> cut(const Grid<float>& raster, int column, int row, int width, int height) {
  Grid<float> part(raster.frame().window(column, row, width, height));
  for (int y = 0; y < height; ++y) {
    const auto from = raster.row(row + y).subspan(static_cast<size_t>(column), static_cast<size_t>(width));
    std::copy(from.begin(), from.end(), part.row(y).begin());
  }
  return part;
}

/// The windows from `first` on that are read together: one after the last of them.
size_t end_of_group(const std::vector<CellWindow>& windows, size_t first) {
  constexpr int64_t kMostCells = int64_t{64} << 20;
  const CellWindow& start = windows[first];
  size_t end = first + 1;
  for (; end < windows.size(); ++end) {
    const CellWindow& next = windows[end];
    if (next.row != start.row || next.height != start.height || next.column < start.column) break;
    if (int64_t{next.column + next.width - start.column} * start.height > kMostCells) break;
  }
  return end;
}

}  // namespace

WindowedRaster windows_of(const Grid<float>& raster, bool heights) {
  return {raster.frame(),
          [&raster](int column, int row, int width, int height) { return cut(raster, column, row, width, height); },
          heights};
}

RasterExtremes extremes_of(const WindowedRaster& raster, const RunContext& run) {
  constexpr int kBand = 64;
  float low = std::numeric_limits<float>::infinity(), high = -low;
  RasterExtremes extremes;
  for (int row = 0; row < raster.frame.height; row += kBand) {
    run.check_cancelled();
    const Grid<float> band = raster.window(0, row, raster.frame.width, std::min(kBand, raster.frame.height - row));
    for (const float z : band.cells()) {
      if (std::isinf(z)) throw InvalidArgument("heights", "a cell is not finite");
      if (std::isnan(z)) {
        ++extremes.unknown_cells;
        continue;
      }
      ++extremes.known_cells;
      low = std::min(low, z);
      high = std::max(high, z);
    }
    run.report(static_cast<double>(row) / raster.frame.height);
  }
  if (extremes.known_cells > 0) extremes.range = {low, high};
  return extremes;
}

void for_each_window(const WindowedRaster& raster, const std::vector<CellWindow>& windows, const RunContext& run,
                     const std::function<void(size_t index, const Grid<float>& cells)>& visit) {
  for (size_t first = 0; first < windows.size();) {
    run.check_cancelled();
    const size_t end = end_of_group(windows, first);
    const CellWindow& start = windows[first];
    int right = 0;
    for (size_t i = first; i < end; ++i) right = std::max(right, windows[i].column + windows[i].width);
    const Grid<float> group = raster.window(start.column, start.row, right - start.column, start.height);
    const auto of_all = [&](size_t i) { return static_cast<double>(i) / static_cast<double>(windows.size()); };
    parallel_blocks(run.part(of_all(first), of_all(end)), static_cast<int64_t>(end - first), 1,
                    [&](int64_t k, int64_t) {
                      const size_t i = first + static_cast<size_t>(k);
                      const CellWindow& own = windows[i];
                      visit(i, cut(group, own.column - start.column, 0, own.width, own.height));
                    });
    first = end;
  }
}

}  // namespace seamount::io
