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
//   saturating      h0 cannot grow through the surface: N lifts by lift_m up to the reef flat, E lifts the rim by
//                   rim_m up to the crest, less in the lee of the swell; sand fills the water between reefs; spurs and
//                   grooves on the fore reef; cays. Land and what stands higher than the reef is never changed.
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
  ScalarField aggregate;  ///< 0 outside the reef, 1 on it, the normal kernel between: one half close to the outline
  LabelMap labels;        ///< reef; lagoon behind it; beach up to 4 m and mountain above; abyss, the open sea
};

/// Grows a reef. Throws InvalidArgument for params out of range, kernels outside the terrain or the habitat, and more
/// particles than there is habitat; IncompatibleInputs for rasters that differ in size. Parallel but for the walks
/// (a few us a particle); three more grids of memory at most; time about linear in cells.
Grown grow(const GrowInputs& in, const GrowParams& params, Seed seed, const RunContext& run);

/// The outlines of an aggregate: where it reaches one half, on cells at least 1 / 2048 of the longer side. One area
/// named reef. Linear in cells.
Drawing reef_outlines(const ScalarField& aggregate, const RunContext& run);

}  // namespace seamount::reef
