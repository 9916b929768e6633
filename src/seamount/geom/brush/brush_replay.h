// Strokes replayed on a grid: rows side by side, strokes in their order on each.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/brush/brush_rows.h"

namespace seamount::geom {

/// The ways of strokes, brush i called name[i] in errors; nullptr: none, a path that reaches nothing. Parallel.
/// `frame`: of a window, that of the whole: what of a stroke lies beyond it does not count.
std::vector<BrushPath> brush_paths(std::span<const Brush* const> brushes, const GridFrame& frame,
                                   const std::string& name, const RunContext& run);

/// Calls draw(i, y, x, weights) for each row of cells that each of the strokes [begin, end) touches, with the weights
/// of the cells from column x on. On a row strokes come in their order; rows run side by side, so draw may change cells
/// of row y alone. The same bits on any number of threads.
void replay(const std::vector<BrushPath>& paths, size_t begin, size_t end, const GridFrame& frame,
            const RunContext& run, const std::function<void(size_t, int, int, std::span<const float>)>& draw);

/// Shares of cells in areas: 1 inside, falling by a smoothstep over `feather_m` beyond the edge, or over one cell about
/// it where that is less.
struct AreaWeights {
  CellWindow window;
  ScalarField weights;  ///< of the window's cells
};

/// Places are inside by the even-odd rule, so that an outline may cross itself. Throws InvalidArgument{name} for no
/// polygon, a ring of fewer than 3 points and for places that are none. Parallel; n log n.
AreaWeights area_weights(const std::vector<Polygon>& polygons, double feather_m, const GridFrame& frame,
                         const std::string& name, const RunContext& run);

}  // namespace seamount::geom
