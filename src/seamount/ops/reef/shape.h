// The form of a reef on a lattice of its own: the distance to the outline of all its colonies, where sand gathers,
// where the swell breaks, and which water is enclosed. Nothing here depends on the terrain's cells, so a preview shows
// the same reef.
#pragma once

#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/reef/kernels.h"

namespace seamount::reef {

/// How outlines are bent away from the discs of their colonies.
struct Bend {
  double amplitude_m = 0.0;  ///< typical displacement; 0: none
  double wavelength_m = 1.0;
};

/// The frame in which forms are computed: `step_m` or as coarse as 4096 nodes a side ask for, the given frame's middle
/// and at least its extent.
GridFrame shape_frame(const GridFrame& frame, double step_m);

/// Signed distance in metres from each node to the outline of the union of the colonies' discs (radius_m), positive
/// inside, after the plane has been bent by noise. -1e6 without colonies. `cells` are the colonies' cells in
/// `lattice`, which finds them by place. Holes smaller than `least_hole_m2` are closed. Exact to about a third of a
/// node. Parallel; about 150 ns a node near the reef.
ScalarField outline_distance(const std::vector<Colony>& colonies, const std::vector<LatticeCell>& cells,
                             const GridFrame& lattice, const GridFrame& frame, const Bend& bend, double least_hole_m2,
                             Seed seed, const RunContext& run);

/// Share of reef around each node, as a Gaussian of deviation sigma_m sees it. Parallel.
ScalarField crowding(const ScalarField& distance, double sigma_m, const RunContext& run);

/// Cosine between the outline's outward normal and the bearing from which swell comes, smoothed over sigma_m: 1 on the
/// windward side, -1 in the lee. Parallel.
ScalarField exposure(const ScalarField& distance, double swell_from_deg, double sigma_m, const RunContext& run);

/// Distance in metres from each node to the open sea: the water that a disc of diameter gap_m reaches from the frame's
/// edge without touching reef or land. 0 in the open sea; where the frame holds no open sea, 1e6. `distance` as
/// above, `ground` on the same frame: what stands above the sea is land. Parallel.
ScalarField distance_to_open_sea(const ScalarField& distance, const HeightField& ground, double gap_m,
                                 const RunContext& run);

}  // namespace seamount::reef
