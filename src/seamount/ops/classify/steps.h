// Sixteen directions on a grid, and its cells in the order that lets each look at the next one along a direction.
#pragma once

#include <array>
#include <cstdlib>
#include <utility>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::classify {

/// A step towards one of 16 directions, as columns and rows.
struct Step {
  int dx, dy;
};

inline constexpr std::array<Step, 16> kSteps = {{{1, 0},
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

/// The two cells between which a step passes that is not along a side; zeros for one that is or that is diagonal and
/// passes a corner.
inline std::pair<Step, Step> cells_beside(Step step) {
  if (std::abs(step.dx) + std::abs(step.dy) != 3) return {{0, 0}, {0, 0}};
  const Step half{step.dx / 2, step.dy / 2};
  return {half, {step.dx - half.dx, step.dy - half.dy}};
}

/// Calls visit(x, y) for all cells, each after the one that a step leads to.
template <class Visit>
void for_each_against(const GridFrame& frame, Step step, const RunContext& run, const Visit& visit) {
  for (int i = 0; i < frame.height; ++i) {
    run.check_cancelled();
    const int y = step.dy > 0 ? frame.height - 1 - i : i;
    for (int j = 0; j < frame.width; ++j) visit(step.dx > 0 ? frame.width - 1 - j : j, y);
  }
}

}  // namespace seamount::classify
