// reef.grow: barrier reefs by diffusion-limited aggregation, on any terrain.
//
// Source: P4. Particles aggregate on a lattice (sec. 3.2, aggregate.h); around each settled particle the normal kernel
// of eq. 1 lifts the ground and the directional log-normal kernel of eq. 2 lifts the outer edge (sec. 3.3, kernels.h);
// blur and normalisation are optional. With heights.mode proportional and kernel.combine sum,
//   h1 = w0 h0 + w1 h0 sum N,  h2 = h1 + w2 h0 sum w_d E,  h0 = height over datum_m.
// P4's "grids radius" is in pixels of its 4096^2 raster: 40 px with a grid of 150, 120 with 50, 30 with 200, always
// 1.465 grid cells, which is the default kernel radius here.
//
// Departures, the defaults (kernel.combine union, heights.mode saturating), because reefs in shallow seas look so:
//   union           N and E over the distance D to the outline of all colonies instead of the distance to a particle,
//                   N(1 - D / R) and E(1 - D / R): the same kernels on one particle, bounded and without seams between
//                   particles, and only the outer edge is lifted, as w_d wants. The outline is bent by noise, radii and
//                   places vary, so neither discs nor lattice show.
//   saturating      h0 cannot grow through the surface: reefs lift the ground by lift_m at most, up to the flat, and
//   the
//                   rim by rim_m up to the crest, less in the lee of the swell. Outside, the side falls with a slope of
//                   its own, gentler in the lee, instead of with N. Wide reefs hold a lagoon behind their flat
//                   (lagoons.h), which drains through passes (passes.h); sand fills the water between reefs; knolls,
//                   spurs and grooves, cays (cays.h). Land and what stands higher than the reef is never changed.
//   light           In saturating mode particles settle, and kernels lift, only between the surface and the depth at
//                   which a tenth of the light is left. Hollows of the land, unknown ground (NaN) and a sea of 0 m
//                   without a floor carry no reef.
//   starts          Without any, each separate piece of habitat has one (pieces.h): P4's centre in a sea of one piece.
#pragma once

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"
#include "seamount/ops/reef/aggregate.h"
#include "seamount/ops/reef/grow_params.h"

namespace seamount::reef {

struct GrowInputs {
  const HeightField& terrain;            ///< metres
  const LabelMap* labels = nullptr;      ///< regions of the terrain: land and sea keep them where no reef grows
  const ScalarField* habitat = nullptr;  ///< particles settle where it is at least one half
  const ScalarField* start = nullptr;    ///< where random kernels lie
  const Drawing* drawing = nullptr;      ///< lines and areas where growth starts
};

struct Grown {
  HeightField terrain;
  ScalarField aggregate;  ///< 0 outside the reef, 1 on it; one half close to the outline, half way down the side
  LabelMap labels;        ///< reef; lagoon behind it; beach up to 4 m and mountain above; abyss, the open sea. Of cays
                          ///< what is higher than plants grow (cays.h) is mountain: land with plants
};

/// Grows a reef. Throws InvalidArgument for params out of range, kernels outside the terrain or the habitat, and more
/// particles than there is habitat; IncompatibleInputs for rasters that differ in size. Parallel but for the walks
/// (a few us a particle); three more grids of memory at most; time about linear in cells.
Grown grow(const GrowInputs& in, const GrowParams& params, Seed seed, const RunContext& run);

/// The outlines of an aggregate: where it reaches one half, on cells at least 1 / 2048 of the longer side. One area
/// named reef. Linear in cells.
Drawing reef_outlines(const ScalarField& aggregate, const RunContext& run);

}  // namespace seamount::reef
