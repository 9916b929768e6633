// hydrology.describe: what a terrain is like, in numbers and curves; with a reference, how far the two are apart.
//
// After P2 sec. 6.5 (histograms of elevation, slope and drainage area, Strahler orders, peaks by prominence and
// isolation) and the descriptors that it cites (Argudo, Guerin, Schott and Galin 2025). All of them are of land, what
// lies above the sea; with a reference both terrains are first brought to the coarser of their cells.
//
// Means and deviations are sums over the values, quantiles are good to a 256th (tally.h): what is measured on a terrain
// does not depend on the reference, but for the settings that both share (cell, channel_m2, min_prominence_m).
//
// Distances are 0 for equal terrains and do not depend on units; where one side has nothing to measure there is none:
//   elevation, slope, curvature, local relief, drainage area (log10), isolation (log10): first Wasserstein distance of
//   the distributions, divided by the reference's standard deviation (by the terrain's where the reference's is 0)
//   aspect: circular Wasserstein distance, over a half turn
//   hypsometry: area between the two hypsometric curves, of heights and areas from 0 to 1
//   slope_area (fall along the flow over its way, channel_slopes.h), roughness: mean |log10 of the ratio| where both
//   curves are defined
//   strahler: mean over orders of |log10 of the ratio| of streams per area; an order that one lacks counts as half
//   a stream
//   prominence: mean over thresholds of |log10 of the ratio| of peaks per area; half a peak where one has none
//   ridges: |log10 of the ratio| of ridge length per area
#pragma once

#include <array>
#include <optional>
#include <string>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"
#include "seamount/model/report.h"

namespace seamount::hydrology {

struct DescribeParams {
  bool sea = true;
  std::optional<double> min_sea_m2;
  double relief_window_m = 1000.0;
  std::optional<double> channel_m2;
  std::optional<double> min_prominence_m;
  std::optional<double> cell_m;
  std::string title;
  std::string reference_title;

  static constexpr auto fields() {
    using P = DescribeParams;
    return std::tuple(
        field(&P::sea, "sea", "describe only what lies above sea level"),
        field(&P::min_sea_m2, "min_sea_m2", "m2", between(0, 1e15), geom::kLeastSeaMeaning),
        field(&P::relief_window_m, "relief_window_m", "m", between(0.01, 1e6), "side of the square of local relief"),
        field(&P::channel_m2, "channel_m2", "m2", between(1, 1e13),
              "catchment with which a river, or a ridge, begins; a 2000th of the smaller land if absent"),
        field(&P::min_prominence_m, "min_prominence_m", "m", between(0.001, 10000),
              "least prominence of a peak; a 50th of the reference's relief if absent"),
        field(&P::cell_m, "cell_m", "m", between(0.01, 1e5),
              "cell size at which both are compared, no finer than theirs; the coarser of these if absent"),
        field(&P::title, "title", "name of the terrain on the page"),
        field(&P::reference_title, "reference_title", "name of the reference on the page"));
  }

  static constexpr std::array kFormerNames = {FormerName{"least_sea_m2", "min_sea_m2"}};
};

struct Described {
  Report report;
  Drawing peaks;  ///< of the terrain, the most prominent first: height as value, prominence_m and isolation_m
};

/// `reference` may be null. Throws InvalidArgument for params out of range, and for a cell_m that is finer than the
/// coarser input's cells or makes more than 2^31 - 1 of them. Parallel in part; linear but for the sorting of passes
/// between catchments; at most 24 bytes per cell besides the inputs (six height fields).
Described describe(const HeightField& terrain, const HeightField* reference, const DescribeParams& params,
                   const RunContext& run);

}  // namespace seamount::hydrology
