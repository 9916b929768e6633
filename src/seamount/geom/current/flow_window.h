// The part of a current that one object reaches.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/model/drawn.h"
#include "seamount/model/vector_field.h"

namespace seamount::geom {

/// Cells [left, left + frame.width) x [top, ...) of a grid, and a flow in them.
struct FlowWindow {
  int left = 0, top = 0;
  VectorField flow;  ///< in the window's own frame; empty: the object reaches no cell
};

/// The cells of a grid within `reach_m` of a box around points, and `spare` more on each side (which may lie beyond the
/// grid). False if none of the grid's lies within the reach.
inline bool window_around(std::span<const Vec2> points, double reach_m, int spare, const GridFrame& grid, int& left,
                          int& top, GridFrame& frame) {
  Vec2 low = points[0], high = points[0];
  for (const Vec2 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const auto bound = [](double v, int last) { return static_cast<int>(std::clamp(v, -1.0, last + 1.0)); };
  const int west = bound(std::floor(grid.column(low.x - reach_m)), grid.width),
            east = bound(std::ceil(grid.column(high.x + reach_m)), grid.width);
  const int north = bound(std::floor(grid.row(high.y + reach_m)), grid.height),
            south = bound(std::ceil(grid.row(low.y - reach_m)), grid.height);
  if (east < 0 || south < 0 || west >= grid.width || north >= grid.height) return false;
  left = std::max(west, 0) - spare;
  top = std::max(north, 0) - spare;
  frame = {std::min(east, grid.width - 1) + spare + 1 - left,
           std::min(south, grid.height - 1) + spare + 1 - top,
           grid.cell_m,
           grid.west_m + left * grid.cell_m,
           grid.north_m - top * grid.cell_m,
           {}};
  return true;
}

/// Adds the windows of `count` objects to a current: made side by side, a batch at a time, and added in order, so that
/// the sum is the same bits on any number of threads.
inline void add_windows(int64_t count, VectorField& current, const RunContext& run,
                        const std::function<FlowWindow(int64_t object, const RunContext& one)>& make) {
  constexpr int64_t kBatch = 64;
  RunContext one = run;
  one.progress = nullptr;
  one.threads = 1;
  for (int64_t first = 0; first < count; first += kBatch) {
    std::vector<FlowWindow> windows(static_cast<size_t>(std::min(kBatch, count - first)));
    parallel_blocks(run.part(static_cast<double>(first) / static_cast<double>(count), 1.0),
                    static_cast<int64_t>(windows.size()), 1,
                    [&](int64_t begin, int64_t) { windows[static_cast<size_t>(begin)] = make(first + begin, one); });
    for (const FlowWindow& window : windows) {
      for (int y = std::max(0, -window.top); y < std::min(window.flow.x.height(), current.x.height() - window.top);
           ++y) {
        for (int x = std::max(0, -window.left); x < std::min(window.flow.x.width(), current.x.width() - window.left);
             ++x) {
          current.x(window.left + x, window.top + y) += window.flow.x(x, y);
          current.y(window.left + x, window.top + y) += window.flow.y(x, y);
        }
      }
    }
  }
}

}  // namespace seamount::geom
