#include "seamount/geom/grid/similarity.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/simd.h"

namespace seamount::geom {
namespace {

/// Keeps the i in [low, high] with -1/2 <= start + i step <= size - 1/2.
void clip(double start, double step, int size, double& low, double& high) {
  if (std::abs(step) < 1e-12) {
    if (start < -0.5 || start > size - 0.5) high = low - 1;
    return;
  }
  const double a = (-0.5 - start) / step, b = (size - 0.5 - start) / step;
  low = std::max(low, std::min(a, b));
  high = std::min(high, std::max(a, b));
}

/// From the place `skip` steps after the start on.
SEAMOUNT_VECTORISED void along_line(float start, float step, int skip, int count, float* __restrict out) {
  for (int i = 0; i < count; ++i) out[i] = start + static_cast<float>(skip + i) * step;
}

}  // namespace

void PlacedRow::locate(const Similarity& placement, const GridFrame& own, const GridFrame& frame, int y, bool all) {
  const GridFrame whole = frame.in_whole();  // lines begin where they do in the whole
  const int left = frame.first_column();
  const Vec2 start = placement.source({whole.x(0), frame.y(y)});
  const Vec2 next = placement.source({whole.x(1), frame.y(y)});
  const double column = own.column(start.x), row = own.row(start.y);
  const double column_step = own.column(next.x) - column, row_step = own.row(next.y) - row;
  double low = 0, high = left + frame.width - 1;
  clip(column, column_step, own.width, low, high);
  clip(row, row_step, own.height, low, high);
  const int begin = all ? 0 : static_cast<int>(std::ceil(low));
  first = std::max(static_cast<int>(std::ceil(low)), left) - left;
  last = std::max(first, static_cast<int>(std::floor(high)) + 1 - left);
  const int from = all ? 0 : first, count = (all ? frame.width : last) - from;
  if (count <= 0) return;
  const int skip = left + from - begin;
  along_line(static_cast<float>(column + begin * column_step), static_cast<float>(column_step), skip, count,
             columns.data() + from);
  along_line(static_cast<float>(row + begin * row_step), static_cast<float>(row_step), skip, count, rows.data() + from);
}

}  // namespace seamount::geom
