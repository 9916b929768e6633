// erosion.refine: the erosion of a coarse terrain, carried on to the small cells of a large one.
//
// Erosion looks at everything, so a world of 65 536 cells a side cannot be eroded as a whole. Its large valleys can be
// found on larger cells: erosion.run on what terrain.resample makes of it. Here they come back. Each cell gets the worn
// height and what it differed from its coarse cell before, as far as sediment has not buried that or the change has
// taken it away; the coarse rivers become smooth courses that fall all the way (coarse_rivers.h), cut through what lies
// across them. Then years of gullies: small pits fill, water gathers over ways of `gather_cells`
// (geom/water/path_areas.h), cuts as rivers do (dh/dt = -K sqrt(Q) dh/dx, implicit as in Braun and Willett 2013, each
// cell towards where its neighbour was), what is too steep over a neighbour fails, and soil creeps. All of that looks a
// stated number of cells far, so a world can be made tile by tile without a seam.
#pragma once

#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/reach.h"

namespace seamount::erosion {

struct RefineParams {
  double years = 3000;
  double detail = 1.0;
  double gullies = 0.6;
  double runoff_mm_yr = 1000;
  double erodibility = 1e-5;
  double channel_m2 = 1000;
  double angle_deg = 55;
  double creep_m2_yr = 0.002;
  double sea_m = 0;
  int gather_cells = 64;

  static constexpr auto fields() {
    using P = RefineParams;
    return std::tuple(
        field(&P::years, "years", "yr", between(0, 1e6),
              "how long gullies cut into the slopes: 0 leaves them to the terrain's own detail"),
        field(&P::detail, "detail", "", between(0, 2),
              "share of the terrain's own detail, finer than the coarse cells, that stays where little was worn or "
              "laid down"),
        field(&P::gullies, "gullies", "", between(0, 2),
              "depth of the gullies that run down bare slopes: 0 none, 1 as in old volcanic islands"),
        field(&P::runoff_mm_yr, "runoff_mm_yr", "mm/yr", between(1, 20000), "rain that runs off, as for erosion.run"),
        field(&P::erodibility, "erodibility", "1/sqrt(m yr)", between(0, 0.1),
              "K in K sqrt(discharge) slope, as for erosion.run"),
        field(&P::channel_m2, "channel_m2", "m2", between(0, 1e8), "area that is drained without a channel"),
        field(&P::angle_deg, "angle_deg", "deg", between(1, 89), "steepest slope over gullies and rivers"),
        field(&P::creep_m2_yr, "creep_m2_yr", "m2/yr", between(0, 10), "diffusivity of soil: rounds crests"),
        field(&P::sea_m, "sea_m", "m", between(-12000, 9000),
              "level of the sea, below which nothing is cut; far below the terrain for none"),
        field(&P::gather_cells, "gather_cells", "", between(8, 512),
              "steps over which water gathers on the fine cells, rounded up to a power of two; some times as many as "
              "fine cells lie along a coarse one. Larger, slower"));
  }
};

/// What was eroded on larger cells: the terrain before and after, the discharge in m3 per year, and if it is known the
/// thickness of what was laid down. All of one frame.
struct CoarseErosion {
  const HeightField& before;
  const HeightField& worn;
  const ScalarField& flow;
  const ScalarField* laid = nullptr;
};

/// The fine terrain, eroded. Beyond the coarse one its border goes on. Throws InvalidArgument for params out of range,
/// IncompatibleInputs for coarse rasters of different frames, or of cells smaller or more than 64 times as large as
/// the terrain's. Parallel; about 0.5 us and 40 bytes per cell.
HeightField refine(const HeightField& terrain, const CoarseErosion& coarse, const RefineParams& params, Seed seed,
                   const RunContext& run);

Reach refine_reach(const RefineParams& params, double cell_m);

}  // namespace seamount::erosion
