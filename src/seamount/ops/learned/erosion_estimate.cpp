#include "seamount/ops/learned/erosion_estimate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/pyramid.h"
#include "seamount/geom/water/facet.h"
#include "seamount/geom/water/settle.h"

namespace seamount::learned {
namespace {

/// K, between erosion.run's of bedrock and of debris, which makes the least error; what rock stands there, and by how
/// much less in hollows of such an area.
constexpr double kErodibility = 1.3e-5, kSteepest = 0.84, kHollowed = 0.03, kHollow_m2 = 1000;
constexpr double kChannel_m2 = 1000;
constexpr double kShareOfRest = 0.3;                    ///< of the remaining years that a coarse grid takes
constexpr int kCoarsestSide = 64;                       ///< grids are halved until the next one would be smaller
constexpr double kReach_m = 2000;                       ///< of what settles in the sea
constexpr float kErodedDepth = 3, kBuriedDepth = 0.1F;  ///< in cells, at which half of a cell's own detail is gone

bool has_coarser(const GridFrame& frame) { return std::min(frame.width, frame.height) / 2 >= kCoarsestSide; }

/// Share of the years that grids coarser than this one take.
double coarse_share(GridFrame frame) {
  double rest = 1;
  for (; has_coarser(frame); frame.width = (frame.width + 1) / 2, frame.height = (frame.height + 1) / 2)
    rest *= 1 - kShareOfRest;
  return 1 - rest;
}

/// The ground after what a grid of half the size made of `start`, its halved(): changes are interpolated, and the
/// ground's own detail goes where much was taken or laid down.
HeightField carried_over(const HeightField& ground, const HeightField& start, const HeightField& made,
                         const RunContext& run) {
  const HeightField before = geom::doubled(start, ground.frame(), run),
                    after = geom::doubled(made, ground.frame(), run);
  HeightField out = ground;
  const auto eroded = static_cast<float>(1 / (kErodedDepth * ground.cell_m())),
             buried = static_cast<float>(1 / (kBuriedDepth * ground.cell_m()));
  parallel_rows(run, ground.width(), ground.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < ground.width(); ++x) {
        const float by = after(x, y) - before(x, y), moved = by * (by > 0 ? buried : eroded), square = moved * moved;
        out(x, y) += by - (ground(x, y) - before(x, y)) * (square / (1 + square));
      }
    }
  });
  return out;
}

}  // namespace

ErosionEstimate estimate_erosion(const HeightField& ground, double years, double sea_m, const RunContext& run) {
  ErosionEstimate out;
  const auto sea = static_cast<float>(sea_m);
  const double before = years * coarse_share(ground.frame()), cell_m2 = ground.cell_m() * ground.cell_m();
  if (has_coarser(ground.frame())) {
    const HeightField half = geom::halved(ground, run);
    out.worn = carried_over(ground, half, estimate_erosion(half, before, sea_m, run).made.heights, run);
  } else {
    out.worn = ground;
  }
  out.filled = geom::fill_depressions(out.worn, sea, run);
  out.directions = geom::flow_directions(out.filled, sea, run);
  geom::turn_to_facets(out.filled, sea, Seed{static_cast<uint64_t>(ground.width())}, out.directions, run);
  out.cells = geom::flow_accumulation(out.directions, run);
  const geom::Incision incision{.rate = static_cast<float>(kErodibility * (years - before)),
                                .deposition = 1.0F,
                                .steepest = static_cast<float>(kSteepest),
                                .hollowed = static_cast<float>(kHollowed),
                                .hollow_cells = static_cast<float>(kHollow_m2 / cell_m2),
                                .channel_cells = static_cast<float>(std::min(0.9, kChannel_m2 / cell_m2))};
  out.made = geom::incise(out.worn, out.directions, out.cells, incision, run);
  geom::settle(out.worn, out.filled, {.sea_level_m = sea, .reach_m = kReach_m}, out.made, run);
  geom::limit_rise(out.made.heights, out.cells, incision, run);
  return out;
}

}  // namespace seamount::learned
