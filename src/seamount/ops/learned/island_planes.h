// What the island synthesizer sees: shares of the five regions in every cell, how far the ground has sunk, and noise;
// the same in training and in use. Source: P0 sec. 1.5 to 1.7; its network sees the painted picture itself (hue,
// value) and makes heights as shares of their range; ours makes metres and may be told the range.
#pragma once

#include <array>
#include <optional>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"
#include "seamount/ops/learned/planes.h"

namespace seamount::learned {

struct IslandMap {
  GridFrame frame;
  std::array<Mask, kRegionCount> shares;  ///< by region number, summing to 1
  ScalarField subsidence;                 ///< [0, 1]; empty: nothing has sunk
  std::optional<double> peak_m, floor_m;  ///< highest and lowest ground, if it is known
  std::optional<double> reef_depth_m;     ///< of the reef's crest below the sea, if it is known
  double scale = 1.0;  ///< size of everything against islands of the training, which are shown on 20 km
};

inline constexpr int kIslandPlanes = 17;

/// Width of the ground that a sample of the training shows, and cells of it.
inline constexpr double kIslandWidth_m = 20480.0;
inline constexpr int kIslandCells = 256;

/// Heights as the network gives them: the signed root of z / (1000 m scale), so that coasts are sharp and summits not
/// cut.
float island_code(double z_m, double scale);
double island_height_m(float code, double scale);

class IslandPlanes {
 public:
  /// Distances to the coast. Parallel, linear; 8 bytes per cell.
  IslandPlanes(const IslandMap& map, Seed seed, const RunContext& run);
  Planes planes() const;

 private:
  void fill_row(int y, float* values) const;

  const IslandMap& map_;  ///< must outlive this
  Seed seed_;
  ScalarField land_, water_;  ///< distances in cells to what is land and what is not
};

}  // namespace seamount::learned
