// island.coral: the island sinks, the reef keeps up. One recipe gives a fringing reef, a barrier reef and an atoll by
// its subsidence alone.
//
// Source: P0 sec. 1.4.2, eq. 1.8 to 1.15, Algorithm 2, with the corrections that heights are in metres about sea level:
// z_s = floor + (1 - lambda) (z - floor) for eq. 1.8, and smax of eq. 1.15 with the coefficient 1 / (2 k) as blend_m.
// Departures, each with a parameter that turns it off: beyond the reef the fore reef falls on at the slope of its talus
// instead of staying at h_abyss (fore_reef_slope_deg = 0); passes off the largest rivers; a reef that is narrower,
// higher and longer of islets to windward (exposure); an uneven floor of the lagoon; islets of sand on the reef.
#pragma once

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"
#include "seamount/ops/island/coral_params.h"

namespace seamount::island {

struct Reefed {
  HeightField terrain;
  LabelMap labels;
};

/// smoothstep between two heights (eq. 1.10). REQUIRES: x0 < x1.
double transition(double a, double b, double x0, double x1, double x);

/// h_coral over x in [0, 1] across the reef (eq. 1.11), constant beyond. Metres.
double coral_profile(const ReefSection& section, double x);

/// z_s = floor + (1 - lambda) (z - floor): eq. 1.8 in metres about sea level.
inline double subside(double z, double floor, double lambda) { return floor + (1.0 - lambda) * (z - floor); }

/// Sinks a terrain and grows its reef. `coordinate` is x~ as island.build makes it; null: derived from the labels, so
/// any DEM with a label map will do. Throws InvalidArgument for params out of range or breakpoints out of order
/// (back_start <= back_end < crest_start <= crest_end < abyss_start), IncompatibleInputs for rasters that differ in
/// size. Parallel; about 20 bytes and 40 ns per cell.
Reefed coral(const HeightField& terrain, const LabelMap& labels, const ScalarField* coordinate,
             const CoralParams& params, Seed seed, const RunContext& run);

}  // namespace seamount::island
