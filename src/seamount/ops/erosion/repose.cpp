#include "seamount/ops/erosion/repose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace seamount::erosion {
namespace {

constexpr float kHigh = std::numeric_limits<float>::infinity();

/// Looks at the four neighbours of a cell that come before it (way -1) or after it (1) in the order of rows.
template <int way>
void limit_cell(ScalarField& level, const Drainage& drainage, const Site& site, float rise, int x, int y) {
  const int width = level.width();
  const int32_t cell = y * width + x;
  float* here = level.data() + cell;
  const bool row = way < 0 ? y > 0 : y + 1 < level.height(), west = x > 0, east = x + 1 < width;
  const auto other = [&](bool exists, int step) { return exists ? here[step] : kHigh; };
  const float straight = std::min(other(way < 0 ? west : east, way), other(row, way * width));
  const float across = std::min(other(row && west, way * width - 1), other(row && east, way * width + 1));
  if (*here <= std::min(straight, across) || drainage.is_root(cell)) return;
  const float own = rise * std::sqrt(value_or_one(site.hardness, cell));
  const float limit = std::min(straight + own, across + std::numbers::sqrt2_v<float> * own);
  if (*here > limit) *here += value_or_one(site.mask, cell) * (limit - *here);
}

}  // namespace

void limit_slopes(ScalarField& level, const Drainage& drainage, const Site& site, double steepest,
                  const RunContext& run) {
  const int width = level.width(), height = level.height();
  const auto rise = static_cast<float>(steepest * level.cell_m());
  for (int y = 0; y < height; ++y) {
    run.check_cancelled();
    for (int x = 0; x < width; ++x) limit_cell<-1>(level, drainage, site, rise, x, y);
  }
  for (int y = height - 1; y >= 0; --y) {
    run.check_cancelled();
    for (int x = width - 1; x >= 0; --x) limit_cell<1>(level, drainage, site, rise, x, y);
  }
}

}  // namespace seamount::erosion
