// Terrains and what erosion.run makes of them: what the erosion synthesizer learns from.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/train/ground_tiles.h"

namespace seamount::train {

inline constexpr int kErodeCells = 256;  ///< of a pair's side

struct ErodePair {
  HeightField before, after;
  double years = 0;
};

/// What erosion.run makes of a terrain: its defaults, in rock of even hardness, since no network can know where rock is
/// hard. Throws as erosion.run.
HeightField eroded(const HeightField& terrain, double years, Seed seed, const RunContext& run);

/// Pair n: a crop of `tiles` or, where there are none and for two of five, noise of every kind, at cells of 10 to 120
/// m, some of it with sea and a quarter of it eroded before; years from kFewestYears to kMostYears. A function of
/// (tiles, n, seed) alone. 0.5 s on one thread.
ErodePair make_erode_pair(const std::vector<GroundTile>& tiles, uint64_t n, Seed seed, const RunContext& run);

}  // namespace seamount::train
