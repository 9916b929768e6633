#include "seamount/ops/classify/exposure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/ops/classify/steps.h"

namespace seamount::classify {
namespace {

constexpr float kOpen = 2.0F;  // a way that is longer than the whole fetch, as a share of it

/// Length of the open way along one direction as a share of the fetch: cells are visited so that the next one that way
/// is known already.
void open_way(const Grid<uint8_t>& barrier, Step step, float step_share, ScalarField& way, const RunContext& run) {
  // A step that is not along a side passes between two cells; a barrier on both of them closes it.
  const auto [a, b] = cells_beside(step);
  const bool knight = a.dx != 0 || a.dy != 0;
  for_each_against(barrier.frame(), step, run, [&, a = a, b = b](int x, int y) {
    const int to_x = x + step.dx, to_y = y + step.dy;
    if (!barrier.contains(to_x, to_y)) {
      way(x, y) = kOpen;
      return;
    }
    const bool between = knight && barrier(x + a.dx, y + a.dy) != 0 && barrier(x + b.dx, y + b.dy) != 0;
    way(x, y) = between || barrier(to_x, to_y) != 0 ? 0.0F : std::min(kOpen, way(to_x, to_y) + step_share);
  });
}

}  // namespace

ScalarField exposure(const Grid<uint8_t>& barrier, double fetch_m, const RunContext& run) {
  const GridFrame& frame = barrier.frame();
  std::vector<ScalarField> ways(kSteps.size());
  parallel_blocks(run, static_cast<int64_t>(kSteps.size()), 1, [&](int64_t begin, int64_t end) {
    for (int64_t d = begin; d < end; ++d) {
      const Step step = kSteps[static_cast<size_t>(d)];
      const double length = frame.cell_m * std::sqrt(static_cast<double>(step.dx * step.dx + step.dy * step.dy));
      ways[static_cast<size_t>(d)] = ScalarField(frame);
      open_way(barrier, step, static_cast<float>(length / fetch_m), ways[static_cast<size_t>(d)], run);
    }
  });
  ScalarField mean(frame, 0.0F);
  for (const ScalarField& way : ways) {
    run.check_cancelled();
    for (size_t i = 0; i < mean.size(); ++i) mean.cells()[i] += geom::smoothstep(2.0F * way.cells()[i] - 1.0F);
  }
  for (float& e : mean.cells()) e *= 1.0F / static_cast<float>(kSteps.size());
  return mean;
}

}  // namespace seamount::classify
