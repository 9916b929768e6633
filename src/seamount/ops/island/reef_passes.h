// Passes: the channels through which a lagoon drains. The first lie off the mouths of the largest rivers, whose fresh
// water and silt keep corals away; the others at seeded random places. They keep their distance from each other, and
// each runs across the reef on the gradient of the region coordinate. Not in P0.
#pragma once

#include <span>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/ops/island/river_mouths.h"

namespace seamount::island {

class ReefPasses {
 public:
  /// Chooses up to `count` places on the reef (x~ in [3, 4]); fewer where the reef is short. A negative count: one for
  /// every 16 km of reef (NATURE: Mayotte), at least two. `mouths`: largest first.
  ReefPasses(const ScalarField& coordinate, int count, double width_m, const std::vector<RiverMouth>& mouths, Seed seed,
             const RunContext& run);

  int count() const { return static_cast<int>(passes_.size()); }
  /// Middle of pass k, on the reef. REQUIRES: k < count().
  Vec2 place(int k) const {
    return 0.5 * (passes_[static_cast<size_t>(k)].inner + passes_[static_cast<size_t>(k)].outer);
  }

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
