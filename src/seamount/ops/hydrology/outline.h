// The outline of cells that belong together.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/contour/contour.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

/// The least window of cells that holds some, both ends included.
struct CellWindow {
  int x0 = std::numeric_limits<int>::max(), x1 = -1, y0 = x0, y1 = -1;
  void add(int x, int y) {
    x0 = std::min(x0, x), x1 = std::max(x1, x);
    y0 = std::min(y0, y), y1 = std::max(y1, y);
  }
};

/// Polygons around the cells of a window for which belongs(x, y); holes are holes. Linear in the window.
template <class Belongs>
std::vector<Polygon> outline_of(CellWindow window, const GridFrame& frame, const Belongs& belongs,
                                const RunContext& run) {
  window.x0 = std::max(0, window.x0 - 1), window.y0 = std::max(0, window.y0 - 1);
  window.x1 = std::min(frame.width - 1, window.x1 + 1), window.y1 = std::min(frame.height - 1, window.y1 + 1);
  GridFrame part = frame;
  part.width = window.x1 - window.x0 + 1;
  part.height = window.y1 - window.y0 + 1;
  part.west_m += window.x0 * frame.cell_m;
  part.north_m -= window.y0 * frame.cell_m;
  Grid<uint8_t> inside(part);
  for (int y = 0; y < part.height; ++y) {
    run.check_cancelled();
    for (int x = 0; x < part.width; ++x) inside(x, y) = belongs(window.x0 + x, window.y0 + y) ? 1 : 0;
  }
  return geom::trace_mask(inside, run);
}

}  // namespace seamount::hydrology
