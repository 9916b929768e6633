// Land beyond the border. A terrain is a piece of a larger land; at a border that is a wall or a cliff, slopes would
// wear on one side only, and a rim would stay. So erosion runs on a terrain that goes on as it is at the border.
#pragma once

#include <algorithm>
#include <optional>

#include "seamount/base/parallel.h"
#include "seamount/ops/erosion/layers.h"

namespace seamount::erosion {

/// A frame with `cells` more on all sides.
inline GridFrame with_margin(GridFrame frame, int cells) {
  frame.west_m -= cells * frame.cell_m;
  frame.north_m += cells * frame.cell_m;
  frame.width += 2 * cells;
  frame.height += 2 * cells;
  return frame;
}

/// Adds a margin that repeats the border's values, or has the value `beyond`; an absent (empty) map stays absent.
/// Parallel, linear.
inline ScalarField extended(const ScalarField& map, int cells, std::optional<float> beyond, const RunContext& run) {
  if (map.empty() || cells == 0) return map;
  ScalarField out(with_margin(map.frame(), cells));
  parallel_rows(run, out.width(), out.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const auto from = map.row(std::clamp(y - cells, 0, map.height() - 1));
      const auto to = out.row(y);
      std::copy(from.begin(), from.end(), to.begin() + cells);
      std::fill_n(to.begin(), cells, beyond.value_or(from.front()));
      std::fill_n(to.end() - cells, cells, beyond.value_or(from.back()));
      if (beyond && (y < cells || y >= cells + map.height())) std::fill(to.begin(), to.end(), *beyond);
    }
  });
  return out;
}

/// What extended() was made of. Linear.
inline ScalarField cropped(const ScalarField& map, const GridFrame& frame, int cells) {
  ScalarField out(frame);
  for (int y = 0; y < frame.height; ++y) {
    const auto from = map.row(y + cells);
    std::copy_n(from.begin() + cells, frame.width, out.row(y).begin());
  }
  return out;
}

}  // namespace seamount::erosion
