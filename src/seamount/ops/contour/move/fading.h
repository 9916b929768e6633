// Weights that let a change of contours fade towards what it must leave alone and towards the edge of the map.
#pragma once

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/model/grid.h"

namespace seamount::contour {

/// A frame over the domain for such weights: eight cells to the fade, about `most_cells` to the domain's longer side at
/// most.
inline GridFrame fading_frame(const GridFrame& domain, double fade_m, int most_cells) {
  GridFrame frame = domain;
  frame.cell_m = std::max(fade_m / 8.0, std::max(domain.width_m(), domain.height_m()) / most_cells);
  frame.width = std::max(2, static_cast<int>(std::ceil(domain.width_m() / frame.cell_m)));
  frame.height = std::max(2, static_cast<int>(std::ceil(domain.height_m() / frame.cell_m)));
  return frame;
}

/// A smoothstep from 0 at the frame's outermost cells, and where room_m(column, row) <= 0, to 1 at fade_m from both
/// (two cells if that is more). `room_m`: how far a cell lies from what is left alone. Parallel.
template <class Room>
ScalarField fading_weight(const GridFrame& frame, double fade_m, const RunContext& run, const Room& room_m) {
  ScalarField weight(frame);
  const double fade = std::max(fade_m, 2.0 * frame.cell_m);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const int cells = std::min(std::min(x, frame.width - 1 - x), std::min(y, frame.height - 1 - y));
        weight(x, y) = static_cast<float>(geom::smoothstep(std::min(cells * frame.cell_m, room_m(x, y)) / fade));
      }
    }
  });
  return weight;
}

}  // namespace seamount::contour
