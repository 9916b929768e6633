// Reading a raster between its cells where some are unknown (NaN).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/model/grid.h"

namespace seamount {

/// Bilinear over the cells that are known, at fractional (column, row), cell centres at whole numbers; NaN where they
/// are less than half of the weight, and more than half a cell beyond the outer centres. REQUIRES: a grid with cells.
inline float sample_known(const Grid<float>& grid, double column, double row) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  constexpr double kEdge = 0.5 + 1e-6;  // of a cell beyond its centre
  if (!(column >= -kEdge && row >= -kEdge && column <= grid.width() - 1 + kEdge && row <= grid.height() - 1 + kEdge))
    return kNone;
  const double x = std::clamp(column, 0.0, grid.width() - 1.0), y = std::clamp(row, 0.0, grid.height() - 1.0);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const double fx = x - x0, fy = y - y0;
  double sum = 0, weight = 0;
  for (int k = 0; k < 4; ++k) {
    const double w = (k % 2 == 0 ? 1 - fx : fx) * (k < 2 ? 1 - fy : fy);
    const float z = grid.clamped(x0 + k % 2, y0 + k / 2);
    if (std::isnan(z)) continue;
    sum += w * z;
    weight += w;
  }
  return weight >= 0.5 ? static_cast<float>(sum / weight) : kNone;
}

}  // namespace seamount
