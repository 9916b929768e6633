// How near the erosion synthesizer is to erosion.run on terrain that it never saw.
#pragma once

#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/ops/learned/network.h"
#include "seamount/train/ground_tiles.h"

namespace seamount::train {

/// Of one terrain, as shares of the mean change that the simulation makes.
struct ErodeMeasure {
  double cell_m = 0, years = 0;
  double change_m = 0;  ///< mean |dz| that the simulation makes
  double off = 0;       ///< mean |dz| between learned.erode and it
  double estimate = 0;  ///< of the estimate alone, without the network
  double seeds = 0;     ///< of another seed of the simulation: what no network can better by much
  double drift = 0;     ///< mean of the result above the simulation's
};

/// Measures `count` terrains of make_erode_pair(): of `tiles`, which training must not have seen, and of noise; of
/// noise alone where there are none. Throws InvalidArgument for a network of other planes; Cancelled. Parallel over
/// terrains, a second each on one thread.
std::vector<ErodeMeasure> measure_erosion(const learned::Network& network, const std::vector<GroundTile>& tiles,
                                          int count, Seed seed, const RunContext& run);

/// The mean of each number.
ErodeMeasure mean_of(const std::vector<ErodeMeasure>& measures);

}  // namespace seamount::train
