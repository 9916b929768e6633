// Beds that a river undermines within a step of an implicit scheme.
//
// A cap over soft rock gives way as fast as rivers clear its foot, not as fast as they would cut it. Slopes that fail
// only after a step would let a scarp go back by a cell or so in thousands of years, so here cells fail as soon as the
// one that they drain to has come down: with rivers, from the outlets up. What fails is carried off as debris, which
// takes its time; and a cell that had to wait for the one below it is cut for what is left of the step, so that a scarp
// goes back by K dt sqrt(Q) and not through all of the soft rock at once. Steps of any length agree within a tenth of
// the relief.
#pragma once

#include <vector>

#include "seamount/ops/erosion/beds.h"
#include "seamount/ops/erosion/drainage.h"

namespace seamount::erosion {

class Undermining {
 public:
  /// `steepest`: rise over run of rock of hardness 1; debris_ease as rivers have it. Without beds nothing fails.
  Undermining(const Layers& ground, const Maps& site, const Drainage& drainage, double steepest, double debris_ease);

  /// How high a cell stands over its receiver at `base` that had its top at `top`.
  float standing(int32_t cell, float base, float top) const;

  /// What is undermined: the river that cuts a cell by `rate` (of rock of hardness 1) has only a share of the step for
  /// it, and the rubble costs it as much as so many metres of such rock. Once for each cell, after its receiver.
  struct Work {
    float share = 1, rubble = 0;
  };
  Work work(int32_t cell, float base, float stands, float top, float rate);

 private:
  const Layers& ground_;
  const Maps& site_;
  const Drainage& drainage_;
  float steepest_, blocks_;
  std::vector<float> ready_;  // share of the step for which a cell has been as low as at its end
};

}  // namespace seamount::erosion
