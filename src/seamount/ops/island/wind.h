// island.wind: strokes of wind and waves that push an island out of its symmetry.
//
// Source: P0 sec. 1.4.1 "Wind deformation", eq. 1.3 to 1.7, Algorithm 1 part 2, and the radial strokes of sec. 1.5,
// fig. 1.38. Departures: the falloff is not normalised, so a stroke's strength is the displacement in metres on the
// stroke itself (paper strength = ours sigma sqrt(2 pi)); a displacement so steep that it would fold the terrain is
// applied in several small steps along the field, which is a bijection, and in one step, eq. 1.6 as printed, otherwise.
#pragma once

#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"

namespace seamount::island {

struct WindParams {
  std::vector<Stroke> strokes;
  Curve resistance = {{{0.0, 0.85}, {0.7, 0.7}, {1.0, 0.35}, {2.0, 0.05}, {3.0, 0.15}, {4.0, 0.4}, {5.0, 1.0}}};
  int radial_count = 0;
  double radial_width_m = 400.0;
  double radial_strength_m = 350.0;
  Vec2 centre;

  static constexpr auto fields() {
    using P = WindParams;
    return std::tuple(
        field(&P::strokes, "strokes",
              "strokes of wind: points, width_m (deviation of the falloff), strength_m (displacement on the stroke)"),
        field(&P::resistance, "resistance", "", between(0, 1),
              "share of the displacement that is withheld, over the region coordinate 0 (summit) to 5 (sea floor)"),
        field(&P::radial_count, "radial_count", "", between(0, 1000),
              "radial strokes from the centre outwards, landward and seaward in turn"),
        field(&P::radial_width_m, "radial_width_m", "m", between(0.1, 1e5), "width of the radial strokes"),
        field(&P::radial_strength_m, "radial_strength_m", "m", between(0, 1e5), "displacement on the radial strokes"),
        field(&P::centre, "centre", "centre of the radial strokes"));
  }
};

struct Warped {
  HeightField terrain;
  LabelMap labels;         ///< empty if there were none
  ScalarField coordinate;  ///< likewise
};

/// h~(p) = h(p - (1 - rho(x~_p)) Phi(p)); labels (nearest) and coordinate move with the terrain. `labels` and
/// `coordinate` may be null; without a coordinate it is derived from the labels, and without labels nothing resists.
/// Throws InvalidArgument for params out of range, IncompatibleInputs for rasters that differ in size. Parallel; cost
/// about 40 ns per cell, plus the strokes.
Warped wind(const HeightField& terrain, const LabelMap* labels, const ScalarField* coordinate, const WindParams& params,
            Seed seed, const RunContext& run);

}  // namespace seamount::island
