// Beds that a river undermines within a step of an implicit scheme.
//
// A cap over soft rock gives way as fast as rivers clear its foot, not as fast as they would cut it. Slopes that fail
// only after a step would let a scarp go back by a cell or so in thousands of years, so here cells fail as soon as the
// one that they drain to has come down: with rivers, from the outlets up. A cell that had to wait for the one below it
// is cut for what is left of the step, so that a scarp goes back by K dt sqrt(Q) and not through all of the soft rock
// at once, and steps of any length agree. What fails goes with the water and costs it nothing.
#pragma once

#include <vector>

#include "seamount/ops/erosion/beds.h"
#include "seamount/ops/erosion/drainage.h"

namespace seamount::erosion {

class Undermining {
 public:
  /// `steepest`: rise over run of rock of hardness 1. Without beds nothing fails.
  Undermining(const Maps& site, const Drainage& drainage, double steepest);

  /// How high a cell stands over its receiver at `base` that had its top at `top`.
  float standing(int32_t cell, float base, float top) const;

  /// Share of the step in which a river that lowers rock of hardness 1 by `rate` cuts a cell. Once for each cell, after
  /// its receiver.
  float time_left(int32_t cell, float stands, float top, float rate);

 private:
  const Maps& site_;
  const Drainage& drainage_;
  float steepest_;
  std::vector<float> ready_;  // share of the step for which a cell has been as low as at its end
};

}  // namespace seamount::erosion
