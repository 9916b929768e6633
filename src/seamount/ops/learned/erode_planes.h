// What the erosion synthesizer sees of a terrain: its form at three sizes, where its water runs, an estimate of what
// rivers will do, and for how long; the same in training and in use.
//
// A convolution sees some hundred cells; how deep a river cuts is decided by all that drains to it. So drainage is
// computed and rivers cut along it (erosion_estimate.h): the network adds what that misses. Heights are shares of the
// mean change that the estimate makes, slopes are true ones, so that one network serves all reliefs, cells and years.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/learned/planes.h"

namespace seamount::learned {

inline constexpr int kErodePlanes = 15;
inline constexpr double kFewestYears = 1000, kMostYears = 300000;  ///< that training shows

class ErodePlanes {
 public:
  /// years > 0. Part of it in parallel; linear; 0.4 us per cell; 100 bytes per cell.
  ErodePlanes(const HeightField& terrain, double years, double sea_m, const RunContext& run);

  Planes planes() const;

  /// The mean change of the estimate in metres; 0 where nothing can change: level ground.
  double unit_m() const { return unit_m_; }
  /// The estimated change, as shares of unit_m(): what the network's result is added to.
  const ScalarField& base() const { return base_; }

 private:
  void fill_row(int y, float* values) const;

  const HeightField& terrain_;  ///< must outlive this
  double years_, sea_m_, unit_m_ = 0;
  ScalarField base_, coarse_;                ///< changes in units: all, and those of the coarser grids
  ScalarField detail_;                       ///< of the estimate: its height over the mean around, in units
  ScalarField near_, far_;                   ///< means of the ground around
  ScalarField drained_, water_m_, descent_;  ///< log2 of cells, depth of hollows, slope of the water's way
  ScalarField load_;                         ///< log2 of what passed, in units
};

}  // namespace seamount::learned
