// Directions around a circle: how many there are of each, where they point on the whole, and how far two sets are
// apart.
#pragma once

#include <array>
#include <cstdint>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

struct Bearings {
  static constexpr size_t kBins = 72;
  static constexpr double kBinDeg = 360.0 / kBins;

  std::array<int64_t, kBins> counts{};
  double north = 0.0, east = 0.0;  ///< sum of unit vectors

  void add(float bearing_deg);
  Bearings& operator+=(const Bearings& other);
  int64_t total() const;
  /// Of the sum of unit vectors, [0, 360). Not a number without bearings.
  double mean_deg() const;
  /// Length of their mean: 1 where all agree, 0 where they cancel. Not a number without bearings.
  double strength() const;
};

/// Downhill bearings on a surface of the terrain's cells above the sea that are not level there. Parallel.
Bearings aspects(const HeightField& terrain, const HeightField& surface, float sea_level_m, const RunContext& run);

/// First Wasserstein distance around the circle, in degrees (Rabin, Delon and Gousseau 2011): the least over all places
/// where it may be cut open. Not a number if one of them is empty.
double circular_wasserstein(const Bearings& a, const Bearings& b);

}  // namespace seamount::hydrology
