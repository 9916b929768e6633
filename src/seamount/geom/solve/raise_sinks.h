// Removal of pits by raising them: each is filled up to where its water would leave, tilted towards that place.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// How the ground may rise.
struct Rising {
  float tilt = 0.0F;         ///< least rise a cell away from the outlet, >= 0
  float most_tilted = 0.0F;  ///< up to this share of the pit's depth above its sill, then by what a float can
  std::function<float(int64_t cell)> ceiling;  ///< no cell is raised above it
};

/// Raises the ground of each sink (find_sinks()) that is not among `allowed` until it falls to where its water leaves:
/// lower ground beyond its sill, the border, or an allowed sink. Without a tilt that is the least surface above the
/// given one, which hangs on it continuously: no height changes by more than the given ones do. A sink below whose sill
/// a ceiling lies stays one, filled as far as that. n log n in the cells that are raised.
void raise_sinks(HeightField& heights, std::span<const int64_t> allowed, const Rising& rising, const RunContext& run);

}  // namespace seamount::geom
