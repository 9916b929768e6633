// Diffusion-limited aggregation on a lattice: particles walk at random until they touch what has grown so far.
//
// Source: P4 sec. 3.2; Witten and Sander, "Diffusion-limited aggregation", Physical Review Letters 47, 1981. Sticking
// is to the eight neighbours (P4), steps are to the four. Departures: walks may be launched from a circle around the
// aggregate, as if from far away (Witten and Sander), instead of from anywhere on the grid; a particle sticks with a
// probability; currents bias the walk; habitat.
//
// Where nothing is near a walker leaps to a circle that is free of the aggregate. For a walk without drift the place
// where it first meets a circle around it is uniform; with drift v and variance s^2 a step it has the density
// exp(v . x / s^2) (Girsanov). From outside the launch circle it comes back at an angle with a wrapped Cauchy
// distribution (the plane's Poisson kernel), so there is no kill circle without drift. The fractal dimension stays that
// of lattice aggregates, 1.71.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/ops/reef/walk_params.h"

namespace seamount::reef {

/// A cell of the lattice: column, and row from the north.
struct LatticeCell {
  int x = 0;
  int y = 0;
  bool operator==(const LatticeCell&) const = default;
};

struct WalkRules {
  int particles = 3000;       ///< shot; fewer are kept where walks end without a place
  int64_t max_steps = 30000;  ///< of one walk; a leap of r cells counts as r^2 steps
  double stickiness = 1.0;    ///< chance to settle at each touch, in (0, 1]
  Vec2 drift;                 ///< mean displacement a step in cells, x east, y north; length at most 0.5
  Launch launch = Launch::ring;
};

struct Aggregate {
  std::vector<LatticeCell> cells;  ///< the kernels, then particles in the order in which they settled
  int lost = 0;                    ///< particles whose walk ended without a place
};

/// Cells of `habitat` that growth from the kernels can reach through habitat (kernels included). Linear time.
int64_t reachable_habitat(const Grid<uint8_t>& habitat, const std::vector<LatticeCell>& kernels);

/// Grows around `kernels` in the cells with habitat != 0. A particle that leaves the grid walks on outside (ring) or is
/// reflected (anywhere; with drift it starts anew in any cell).
/// REQUIRES: kernels within the grid and without repetition, particles <= free reachable habitat.
/// Throws Cancelled. Sequential by nature; about 2 us a particle at stickiness 1 beside 1 us x side of the leaps.
Aggregate aggregate(const Grid<uint8_t>& habitat, const std::vector<LatticeCell>& kernels, const WalkRules& rules,
                    Seed seed, const RunContext& run);

}  // namespace seamount::reef
