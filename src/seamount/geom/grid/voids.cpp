#include "seamount/geom/grid/voids.h"

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

}  // namespace seamount::geom
