#include "seamount/ops/classify/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/scalar/blend.h"

namespace seamount::classify {
namespace {

/// A step towards one of 16 directions, as columns and rows.
struct Step {
  int dx, dy;
};

constexpr std::array<Step, 16> kSteps = {{{1, 0},
                                          {2, 1},
                                          {1, 1},
                                          {1, 2},
                                          {0, 1},
                                          {-1, 2},
                                          {-1, 1},
                                          {-2, 1},
                                          {-1, 0},
                                          {-2, -1},
                                          {-1, -1},
                                          {-1, -2},
                                          {0, -1},
                                          {1, -2},
                                          {1, -1},
                                          {2, -1}}};

constexpr float kOpen = 2.0F;  // a way that is longer than the whole fetch, as a share of it

/// Length of the open way along one direction as a share of the fetch: cells are visited so that the next one that way
/// is known already.
void open_way(const Grid<uint8_t>& barrier, Step step, float step_share, ScalarField& way, const RunContext& run) {
  const int width = barrier.width(), height = barrier.height();
  // A step that is not along a side passes between two cells; a barrier on both of them closes it.
  const bool knight = std::abs(step.dx) + std::abs(step.dy) == 3, diagonal = std::abs(step.dx * step.dy) == 1;
  const int half_x = diagonal ? step.dx : step.dx / 2, half_y = diagonal ? 0 : step.dy / 2;
  for (int i = 0; i < height; ++i) {
    run.check_cancelled();
    const int y = step.dy > 0 ? height - 1 - i : i;
    for (int j = 0; j < width; ++j) {
      const int x = step.dx > 0 ? width - 1 - j : j;
      const int to_x = x + step.dx, to_y = y + step.dy;
      if (!barrier.contains(to_x, to_y)) {
        way(x, y) = kOpen;
        continue;
      }
      const bool between =
          knight && barrier(x + half_x, y + half_y) != 0 && barrier(x + step.dx - half_x, y + step.dy - half_y) != 0;
      way(x, y) = between || barrier(to_x, to_y) != 0 ? 0.0F : std::min(kOpen, way(to_x, to_y) + step_share);
    }
  }
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
