// hydrology.flow: where water runs, and how much of it gathers.
//
// Depressions are filled and flats drained first (geom/water/flow.h). Directions after O'Callaghan and Mark 1984 (D8),
// Tarboton 1997 (D-infinity), Freeman 1991 and Holmgren 1994 (multiple).
#pragma once

#include <array>
#include <optional>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

enum class FlowMethod { d8, dinf, mfd };

struct FlowParams {
  FlowMethod method = FlowMethod::d8;
  double exponent = 1.1;
  bool sea = true;
  std::optional<double> min_sea_m2;
  std::optional<double> min_catchment_m2;

  static constexpr auto fields() {
    using P = FlowParams;
    return std::tuple(
        field(&P::method, "method", "d8: to the steepest neighbour; dinf: between two; mfd: over all that are lower"),
        field(&P::exponent, "exponent", "", between(0.1, 20),
              "mfd: shares go with slope to this power; higher gathers more"),
        field(&P::sea, "sea", "flow ends in cells at or below sea level; otherwise only at the terrain's edge"),
        field(&P::min_catchment_m2, "min_catchment_m2", "m2", between(0, 1e15),
              "smaller catchments are not traced; a five-hundredth of the terrain's area if absent"),
        field(&P::min_sea_m2, "min_sea_m2", "m2", between(0, 1e15), geom::kLeastSeaMeaning));
  }

  static constexpr std::array kFormerNames = {FormerName{"least_sea_m2", "min_sea_m2"}};
};

struct Flow {
  HeightField terrain;        ///< filled; lakes are flat
  ScalarField cells;          ///< that drain through a cell, itself included
  ScalarField area_m2;        ///< the same as an area
  ScalarField direction_deg;  ///< bearing of the flow, clockwise from north; -1 where it ends; D8's for mfd
  /// Number of the catchment that a cell belongs to, 1 the largest; 0 for open water. D8's for all methods.
  ScalarField basins;
  Drawing catchments;  ///< the larger of them as areas "catchment 1", ... with area_m2, mouth_x and mouth_y
};

/// Area in m2 from which on a catchment is drawn: as asked for, or else a five hundredth of the terrain.
double least_catchment_m2(const FlowParams& params, const GridFrame& frame);

/// A catchment is what drains through one cell of the border or of the sea, or into sinks that hang together: cells
/// where `sinks` (may be null) is above 0, in which flow ends, as in the closed lakes of hydrology.lakes. The sum of
/// `cells` over the ends of flow is the number of cells. Throws InvalidArgument for params out of range,
/// IncompatibleInputs for sinks of another size. Parallel, linear; 17 bytes per cell besides the results.
Flow flow(const HeightField& terrain, const ScalarField* sinks, const FlowParams& params, const RunContext& run);
/// Without sinks.
inline Flow flow(const HeightField& terrain, const FlowParams& params, const RunContext& run) {
  return flow(terrain, nullptr, params, run);
}

}  // namespace seamount::hydrology

template <>
struct seamount::Choices<seamount::hydrology::FlowMethod> {
  static constexpr std::array<std::string_view, 3> names = {"d8", "dinf", "mfd"};
};
