// Passes: the channels through which a lagoon drains. Placed along the reef at seeded random places that keep their
// distance from each other, each across the reef on the gradient of the region coordinate. Not in P0.
#pragma once

#include <span>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::island {

class ReefPasses {
 public:
  /// Chooses up to `count` places on the reef (x~ in [3, 4]); fewer where the reef is short.
  ReefPasses(const ScalarField& coordinate, int count, double width_m, Seed seed, const RunContext& run);

  /// Mean width of the reef in metres; 500 if there is no reef.
  double reef_width_m() const { return reef_width_m_; }

  /// out[x] = how much a cell of row y lies in a pass: 1 in the channel, 0 outside, soft walls between.
  void row(const GridFrame& frame, int y, std::span<float> out) const;

 private:
  struct Pass {
    Vec2 inner, outer;
    double half_width_m;
  };
  std::vector<Pass> passes_;
  double reef_width_m_ = 500.0;
};

}  // namespace seamount::island
