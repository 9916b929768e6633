// terrain.compose: several terrains in one domain, each moved, turned, scaled and raised, with feathered seams.
//
// Terrains lie over each other in their order. Towards its own edge a terrain fades over feather_m into what lies below
// it; where nothing does it keeps its height up to its edge. Cells without a height (NaN) let what lies below show.
// With colour and coverage instead of height this is the "over" of Porter and Duff (Compositing digital images, 1984):
// w_k smoothstep of the distance from the edge, A the coverage so far,  z <- (w_k z_k + (1 - w_k) A z) / (w_k + (1 -
// w_k) A),  A <- w_k + (1 - w_k) A.
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/model/reach.h"

namespace seamount::terrain {

struct ComposeParams {
  Polyline places;
  std::vector<double> turns_deg;
  std::vector<double> scales;
  std::vector<double> raises_m;
  double feather_m = 500.0;
  std::optional<double> outside_m;

  static constexpr auto fields() {
    using P = ComposeParams;
    return std::tuple(
        field(&P::places, "places",
              "where each terrain's middle goes; a single terrain is copied to every place; none: terrains "
              "lie where their coordinates put them"),
        field(&P::turns_deg, "turns_deg", "deg", between(-360, 360),
              "how far each terrain is turned, counter-clockwise; missing ones are 0"),
        field(&P::scales, "scales", "", between(0.01, 100),
              "how much each terrain is scaled, width and height alike; missing ones are 1"),
        field(&P::raises_m, "raises_m", "m", between(-20000, 20000),
              "how far each terrain is raised after scaling; missing ones are 0"),
        field(&P::feather_m, "feather_m", "m", between(0, 1e7), "width of the seams; 0: cut sharply"),
        field(&P::outside_m, "outside_m", "m", between(-12000, 9000),
              "height of the plain on which all terrains lie; if absent such ground stays unknown, for learned.sketch "
              "to make"));
  }
};

/// The frame that holds all terrains where they lie, on the lattice of the first. REQUIRES: at least one. Throws
/// InvalidArgument{"terrain"} for more than 65536 cells a side or 2^30 in all.
GridFrame frame_around(const std::vector<const HeightField*>& terrains);

/// Lays terrains on a frame. Throws IncompatibleInputs for one that lies nowhere on it. Terrains finer than the frame
/// are averaged. Throws InvalidArgument for params out of range and a number of places that fits neither one terrain
/// nor all of them. Parallel; about 20 ns per cell and terrain.
HeightField compose(const std::vector<const HeightField*>& terrains, const ComposeParams& params,
                    const GridFrame& frame, const RunContext& run);

/// Each cell hangs on the terrains alone, if nothing is said of the whole.
Reach compose_reach(const ComposeParams& params);

}  // namespace seamount::terrain
