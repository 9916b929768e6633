// terrain.smooth: a terrain with its detail taken off, all over or by a mask; or with more of it.
#pragma once

#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/reach.h"

namespace seamount::terrain {

struct SmoothParams {
  double radius_m = 60.0;
  double strength = 1.0;

  static constexpr auto fields() {
    using P = SmoothParams;
    return std::tuple(
        field(&P::radius_m, "radius_m", "m", between(0, 1e5), "size of what vanishes: deviation of the Gaussian"),
        field(&P::strength, "strength", "", between(-3, 1),
              "1 smooths wholly, 0 not at all; below 0 detail is exaggerated instead"));
  }
};

/// h + mask strength (G h - h) with the Gaussian mean G, mask (may be null) in [0, 1]. The mean height stays but at the
/// border, where the terrain goes on with its edge. Throws InvalidArgument for params out of range, IncompatibleInputs
/// for a mask of another size. Parallel; about 10 ns a cell whatever the radius; two grids of memory.
HeightField smooth(const HeightField& terrain, const ScalarField* mask, const SmoothParams& params,
                   const RunContext& run);

Reach smooth_reach(const SmoothParams& params, double cell_m);

}  // namespace seamount::terrain
