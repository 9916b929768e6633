#include "seamount/geom/grid/voids.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"

namespace seamount::geom {
namespace {

SEAMOUNT_VECTORISED int count_unknown(const float* values, int count) {
  int unknown = 0;
  for (int i = 0; i < count; ++i) unknown += values[i] != values[i] ? 1 : 0;
  return unknown;
}

}  // namespace

bool any_void(std::span<const float> values) {
  return count_unknown(values.data(), static_cast<int>(values.size())) > 0;
}

int64_t count_voids(const Grid<float>& grid, const RunContext& run) {
  constexpr int64_t kRows = 64;
  return parallel_sum<int64_t>(run, grid.height(), kRows, [&](int64_t begin, int64_t end) {
    int64_t count = 0;
    for (int64_t y = begin; y < end; ++y) count += count_unknown(grid.row(static_cast<int>(y)).data(), grid.width());
    return count;
  });
}

float sample_known(const Grid<float>& grid, double column, double row) {
  constexpr double kEdge = 0.5 + 1e-6;
  if (!(column >= -kEdge && row >= -kEdge && column <= grid.width() - 1 + kEdge && row <= grid.height() - 1 + kEdge))
    return std::numeric_limits<float>::quiet_NaN();
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
  return weight >= 0.5 ? static_cast<float>(sum / weight) : std::numeric_limits<float>::quiet_NaN();
}

}  // namespace seamount::geom
