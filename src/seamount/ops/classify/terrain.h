// classify.terrain: the five regions of any terrain, a real one included, so that it can enter the methods that build
// on labels (island.coral, learned.island).
//
// The regions are those of P0 sec. 1.4.1; how a terrain without a plan gets them is ours:
//   beach     low, gentle land near the sea;  mountain  all other land
//   exposure  how open to the sea a place is: the mean over 16 directions of the fetch, the distance to land or to
//             a bar (ground shallower than bar_m), as a share of fetch_m; beyond the frame's edge lies open sea. Fetch
//             as in Håkanson and Jansson, Principles of Lake Sedimentology, 1983, over directions instead of winds
//   reef      bars within reef_width_m of exposed water, exposed ground down to reef_depth_m, and the fore reef: what
//             falls from there, steeper than fore_reef_slope_deg, down to fore_reef_m
//   lagoon    sheltered water down to lagoon_depth_m, and water on the platform behind a belt of reefs (belt.h), which
//             swell reaches from along the coast but not from the deep;  abyss  all other water
// Sea that is 0 everywhere, as land elevation models give it, is of unknown depth and becomes abyss.
#pragma once

#include <array>
#include <optional>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"

namespace seamount::classify {

struct TerrainParams {
  double beach_m = 5.0;
  double beach_width_m = 400.0;
  double beach_slope_deg = 10.0;
  double bar_m = 6.0;
  double fetch_m = 15000.0;
  double exposed = 0.2;
  double reef_depth_m = 20.0;
  double reef_width_m = 1200.0;
  double fore_reef_m = 80.0;
  double fore_reef_slope_deg = 12.0;
  double lagoon_depth_m = 80.0;
  double belt_gap_m = 20000.0;
  double scale_m = 60.0;
  double min_patch_m2 = 20000.0;
  std::optional<double> min_sea_m2;

  static constexpr auto fields() {
    using P = TerrainParams;
    return std::tuple(
        field(&P::beach_m, "beach_m", "m", between(0, 500), "height up to which land by the sea can be beach"),
        field(&P::beach_width_m, "beach_width_m", "m", between(0, 1e6), "how far from the water beach reaches"),
        field(&P::beach_slope_deg, "beach_slope_deg", "deg", between(0, 90), "steepest beach"),
        field(&P::bar_m, "bar_m", "m", between(0, 500), "depth down to which ground breaks the swell"),
        field(&P::fetch_m, "fetch_m", "m", between(1, 1e7), "distance over open water that counts as fully open"),
        field(&P::exposed, "exposed", "", between(0, 1), "share of open directions from which water counts as exposed"),
        field(&P::reef_depth_m, "reef_depth_m", "m", between(0, 1000), "depth down to which exposed ground is reef"),
        field(&P::reef_width_m, "reef_width_m", "m", between(0, 1e6),
              "how far from exposed water bars are reef, and benches from deep water"),
        field(&P::fore_reef_m, "fore_reef_m", "m", between(0, 5000), "depth of the foot of the fore reef"),
        field(&P::fore_reef_slope_deg, "fore_reef_slope_deg", "deg", between(0.1, 89),
              "least slope of the fore reef, from the reef's edge"),
        field(&P::lagoon_depth_m, "lagoon_depth_m", "m", between(0, 5000),
              "depth down to which sheltered water is lagoon"),
        field(&P::belt_gap_m, "belt_gap_m", "m", between(0, 1e6),
              "widest pass between two reefs of a belt; what lies behind a belt is lagoon"),
        field(&P::scale_m, "scale_m", "m", between(0, 1e5), "forms smaller than this do not count as slope"),
        field(&P::min_patch_m2, "min_patch_m2", "m2", between(0, 1e12), "smaller patches go to what lies around them"),
        field(&P::min_sea_m2, "min_sea_m2", "m2", between(0, 1e15), geom::kLeastSeaMeaning));
  }

  static constexpr std::array kFormerNames = {FormerName{"smallest_m2", "min_patch_m2"},
                                              FormerName{"least_sea_m2", "min_sea_m2"}};
};

struct Classified {
  LabelMap labels;
  ScalarField exposure;  ///< openness to the sea, 0 to 1; 0 on land
};

/// Labels a terrain with heights in metres about its sea level. Throws InvalidArgument for params out of range, an
/// empty terrain and heights that are not finite. Exposure is found on at most 1024 cells a side. Parallel but for the
/// removal of small patches; about 60 ns and 30 bytes per cell.
Classified terrain(const HeightField& terrain, const TerrainParams& params, const RunContext& run);

}  // namespace seamount::classify
