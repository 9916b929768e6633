// terrain.terrace: slopes become steps, as where hard beds lie in soft ones: level treads and steep risers.
//
// Heights are mapped by a monotone curve, so what was higher stays higher. Treads have thicknesses of their own and
// wander with noise, because beds do; a few thousand years of erosion.run after it make a canyon's walls.
#pragma once

#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::terrain {

struct TerraceParams {
  double step_m = 80.0;
  double flatness = 0.75;
  double riser = 0.25;
  double variation = 0.5;
  double wander_m = 15.0;
  double wander_wavelength_m = 3000.0;

  static constexpr auto fields() {
    using P = TerraceParams;
    return std::tuple(
        field(&P::step_m, "step_m", "m", between(0.01, 5000), "mean height from tread to tread"),
        field(&P::flatness, "flatness", "", between(0, 1), "0 leaves the slope as it is, 1 makes treads level"),
        field(&P::riser, "riser", "", between(0.02, 1), "share of the slope that becomes the riser of a step"),
        field(&P::variation, "variation", "", between(0, 1), "how much thicknesses of steps differ"),
        field(&P::wander_m, "wander_m", "m", between(0, 2000), "how far a tread's height wanders from place to place"),
        field(&P::wander_wavelength_m, "wander_wavelength_m", "m", between(1, 1e6), "over what distance it does"));
  }
};

/// Monotone in the height at every place; no height changes by more than its step. Treads lie on heights that depend on
/// the seed alone, not on the terrain or its cells. The mask (may be null) mixes in [0, 1]. Throws InvalidArgument for
/// params out of range, IncompatibleInputs for a mask of another size. Parallel; about 30 ns a cell.
HeightField terrace(const HeightField& terrain, const ScalarField* mask, const TerraceParams& params, Seed seed,
                    const RunContext& run);

}  // namespace seamount::terrain
