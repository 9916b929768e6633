// terrain.sea_floor: a plausible floor for the sea of elevation models of land, which give it as 0 m everywhere.
//
// The floor goes on from the land: it begins at the coast with a share of the slope that the land has there, spread
// over the sea as a membrane, and flattens towards the greatest depth: depth = D (1 - exp(-s d / D)) at the distance d
// from the land.
#pragma once

#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::terrain {

struct SeaFloorParams {
  double depth_m = 200.0;
  double steepness = 0.5;
  double min_slope_deg = 0.3;
  double shore_m = 1500.0;

  static constexpr auto fields() {
    using P = SeaFloorParams;
    return std::tuple(
        field(&P::depth_m, "depth_m", "m", between(1, 11000), "greatest depth, far from land"),
        field(&P::steepness, "steepness", "", between(0, 10),
              "slope of the floor at the coast, as a share of the land's"),
        field(&P::min_slope_deg, "min_slope_deg", "deg", between(0.01, 60), "least slope of the floor at the coast"),
        field(&P::shore_m, "shore_m", "m", between(1, 1e5), "how far inland the slope of the land is measured"));
  }
};

/// The terrain with a floor where it is 0 m exactly and hangs together over at least a hundredth of its cells; land and
/// any other sea stay to the bit. Says so where there is no such sea. Throws InvalidArgument for params out of range.
/// Linear, parallel.
HeightField sea_floor(const HeightField& terrain, const SeaFloorParams& params, const RunContext& run);

}  // namespace seamount::terrain
