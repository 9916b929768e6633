#include "seamount/ops/learned/sketch_level.h"

#include <algorithm>
#include <utility>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/ops/learned/plane_math.h"

namespace seamount::learned {
namespace {

constexpr double kWide = 6, kSoft = 4;       ///< deviations of means of the ground and of its moves, in cells
constexpr float kReach = 14, kLift = 0.18F;  ///< cells, share of the relief
constexpr float kUsual = 0.6F, kPerShare = 0.5F, kLowest = 0.25F;

/// Distance in cells from the nearest cell of the other side.
ScalarField from_side(const Grid<int8_t>& level, int8_t side, const RunContext& run) {
  GridFrame frame = level.frame();
  frame.cell_m = 1;
  Grid<uint8_t> cells(frame, 0);
  for (size_t i = 0; i < cells.size(); ++i) cells.data()[i] = level.data()[i] == side ? 1 : 0;
  return geom::distance_to(cells, run);
}

/// How far means lie on the wrong side of what they should; `other`: cells from the other side.
SEAMOUNT_VECTORISED void moves_of_row(const int8_t* level, const float* from_low, const float* from_high, float middle,
                                      float lift, int width, float* means) {
  for (int x = 0; x < width; ++x) {
    const float up = middle + lift * fast_tanh(from_low[x] / kReach) - means[x],
                down = middle - lift * fast_tanh(from_high[x] / kReach) - means[x];
    means[x] = level[x] > 0 ? std::max(0.0F, up) : level[x] < 0 ? std::min(0.0F, down) : 0.0F;
  }
}

}  // namespace

void meet_level(const SketchMap& map, double adherence, HeightField& heights, const RunContext& run) {
  if (map.level.empty() || !(adherence > 0)) return;
  const auto high = std::count(map.level.cells().begin(), map.level.cells().end(), int8_t{1});
  const auto low = std::count(map.level.cells().begin(), map.level.cells().end(), int8_t{-1});
  if (high == 0 || low == 0) return;
  const float share = static_cast<float>(high) / static_cast<float>(high + low);
  const auto relief = static_cast<float>(map.relief_m);
  const float middle = static_cast<float>(map.low_m) + relief * std::max(kLowest, kUsual - kPerShare * share);
  const ScalarField from_low = from_side(map.level, -1, run), from_high = from_side(map.level, 1, run);
  ScalarField moves = heights;
  geom::gaussian_blur(moves, kWide * map.frame.cell_m, run);
  parallel_rows(run, map.frame.width, map.frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      moves_of_row(map.level.row(y).data(), from_low.row(y).data(), from_high.row(y).data(), middle, kLift * relief,
                   map.frame.width, moves.row(y).data());
    }
  });
  geom::gaussian_blur(moves, kSoft * map.frame.cell_m, run);
  for (size_t i = 0; i < heights.size(); ++i) heights.data()[i] += static_cast<float>(adherence) * moves.data()[i];
}

}  // namespace seamount::learned
