// island.coral: the island sinks, the reef keeps up. One recipe gives a fringing reef, a barrier reef and an atoll by
// its subsidence alone.
//
// Source: P0 sec. 1.4.2, eq. 1.8 to 1.15, Algorithm 2, with the corrections that heights are in metres about sea level:
// z_s = floor + (1 - lambda) (z - floor) for eq. 1.8, and smax of eq. 1.15 with the coefficient 1 / (2 k) as blend_m.
// Departures, each with a parameter that turns it off: beyond the reef the fore reef falls on at the slope of its talus
// instead of staying at h_abyss (fore_reef_slope_deg = 0); passes; an uneven floor of the lagoon; islets of sand on the
// reef.
#pragma once

#include <optional>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"

namespace seamount::island {

struct CoralParams {
  double subsidence = 0.0;
  double crest_m = -2.0;
  double back_m = -20.0;
  double abyss_m = -100.0;
  double back_start = 0.0;
  double back_end = 0.5;
  double crest_start = 0.75;
  double crest_end = 0.8;
  double abyss_start = 1.0;
  double fore_reef_slope_deg = 28.0;
  double blend_m = 1.0;
  std::optional<double> floor_m;
  int passes = 5;
  double pass_width_m = 350.0;
  double pass_depth_m = 18.0;
  double lagoon_relief_m = 5.0;
  double islets = 0.3;
  double islet_m = 3.0;
  bool relabel = true;

  static constexpr auto fields() {
    using P = CoralParams;
    return std::tuple(
        field(&P::subsidence, "subsidence", "", between(0, 1),
              "share of its height over the sea floor by which the island has sunk"),
        field(&P::crest_m, "crest_m", "m", between(-200, 50), "height of the reef crest"),
        field(&P::back_m, "back_m", "m", between(-500, 50), "height of the back reef and of the lagoon's floor"),
        field(&P::abyss_m, "abyss_m", "m", between(-5000, 50), "height at the foot of the fore reef"),
        field(&P::back_start, "back_start", "", between(0, 1),
              "where the back reef starts across the reef (0: inner border, 1: outer border)"),
        field(&P::back_end, "back_end", "", between(0, 1), "where the back reef ends and rises to the crest"),
        field(&P::crest_start, "crest_start", "", between(0, 1), "where the crest starts"),
        field(&P::crest_end, "crest_end", "", between(0, 1), "where the crest ends and the fore reef falls"),
        field(&P::abyss_start, "abyss_start", "", between(0, 1), "where the fore reef reaches abyss_m"),
        field(&P::fore_reef_slope_deg, "fore_reef_slope_deg", "deg", between(0, 80),
              "slope on which the fore reef goes on beyond the reef; 0: stays at abyss_m"),
        field(&P::blend_m, "blend_m", "m", between(0.001, 100),
              "how much the smooth maximum of island and reef exceeds both where they are equal"),
        field(&P::floor_m, "floor_m", "m", between(-12000, 9000),
              "height that does not sink; the lowest of the terrain if absent"),
        field(&P::passes, "passes", "", between(0, 200), "channels through the reef"),
        field(&P::pass_width_m, "pass_width_m", "m", between(1, 1e5), "width of a pass"),
        field(&P::pass_depth_m, "pass_depth_m", "m", between(0, 500), "depth of a pass"),
        field(&P::lagoon_relief_m, "lagoon_relief_m", "m", between(0, 100),
              "height of patch reefs and hollows on the lagoon's floor"),
        field(&P::islets, "islets", "", between(0, 1), "share of the reef that carries islets of sand"),
        field(&P::islet_m, "islet_m", "m", between(0, 20), "height of the islets"),
        field(&P::relabel, "relabel",
              "label what has sunk below the sea and the deep back reef as lagoon, and beaches along the new coast"));
  }
};

struct Reefed {
  HeightField terrain;
  LabelMap labels;
};

/// smoothstep between two heights (eq. 1.10). REQUIRES: x0 < x1.
double transition(double a, double b, double x0, double x1, double x);

/// h_coral over x in [0, 1] across the reef (eq. 1.11), constant beyond. Metres.
double coral_profile(const CoralParams& params, double x);

/// z_s = floor + (1 - lambda) (z - floor): eq. 1.8 in metres about sea level.
inline double subside(double z, double floor, double lambda) { return floor + (1.0 - lambda) * (z - floor); }

/// Sinks a terrain and grows its reef. `coordinate` is x~ as island.build makes it; null: derived from the labels, so
/// any DEM with a label map will do. Throws InvalidArgument for params out of range or breakpoints out of order
/// (back_start <= back_end < crest_start <= crest_end < abyss_start), IncompatibleInputs for rasters that differ in
/// size. Parallel; about 20 bytes and 40 ns per cell.
Reefed coral(const HeightField& terrain, const LabelMap& labels, const ScalarField* coordinate,
             const CoralParams& params, Seed seed, const RunContext& run);

}  // namespace seamount::island
