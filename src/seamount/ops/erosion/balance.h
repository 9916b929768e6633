// Where the ground went in an erosion run: what bedrock lost, where it lies now, what left the map.
//
// Bedrock worn + the loose ground (debris, sediment) before = the loose ground after + what left over the border;
// bedrock is surface - debris - sediment. The error is what a run's rounding adds or loses, at most 1e-4 of what was
// picked up.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/report.h"
#include "seamount/ops/erosion/run.h"

namespace seamount::erosion {

/// The ground of a run before it; maps that were not given are nullptr.
struct Before {
  const HeightField& terrain;
  const ScalarField* debris = nullptr;
  const ScalarField* sediment = nullptr;
};

/// Volumes in m3. worn = on_land + under_water + exported + error.
struct Balance {
  double worn = 0;     ///< bedrock that became debris or sediment; what was uplifted is none of it
  double on_land = 0;  ///< change of debris and sediment that lie on dry cells at the end; negative: less than before
  double under_water = 0;  ///< the same under sea and lakes
  double exported = 0;     ///< left over the border; negative: more came to lie on hollows' floors than left
  double uplifted = 0;
  /// By water, waves and failing slopes, most of it more than once; not what slides from cell to cell.
  double picked_up = 0;
  double error = 0;
};

/// REQUIRES: `after` is what a run made of `before`. One thread, one pass.
Balance balance(const Before& before, const Eroded& after, const RunParams& params);

/// The balance as numbers by name, beside a histogram of how far the surface rose or sank.
Report balance_report(const Before& before, const Eroded& after, const RunParams& params, const RunContext& run = {});

}  // namespace seamount::erosion
