// What erosion works on: three layers of material per cell, and where and how easily they wear.
//
// Layers after Benes and Forsbach 2001: bedrock below, then debris (coarse, from slopes), then fine sediment. The
// surface is stored, and bedrock is what is left: surface - debris - sediment.
#pragma once

#include <algorithm>

#include "seamount/base/simd.h"
#include "seamount/model/grid.h"

namespace seamount::erosion {

/// The layers of a terrain. Debris and sediment are thicknesses in metres, never negative.
struct Layers {
  HeightField surface;
  ScalarField debris;
  ScalarField sediment;

  const GridFrame& frame() const { return surface.frame(); }
  /// Takes `depth` >= 0 metres from the top of a cell: sediment, then debris, then bedrock.
  void lower(size_t cell, float depth) {
    surface.data()[cell] -= depth;
    float& fine = sediment.data()[cell];
    const float from_fine = std::min(fine, depth);
    fine -= from_fine;
    float& coarse = debris.data()[cell];
    coarse -= std::min(coarse, depth - from_fine);
  }
  /// Height of the bedrock's top.
  float bedrock(size_t cell) const { return surface.data()[cell] - debris.data()[cell] - sediment.data()[cell]; }
  /// Lays `depth` >= 0 metres of fine sediment on a cell.
  void bury(size_t cell, float depth) {
    surface.data()[cell] += depth;
    sediment.data()[cell] += depth;
  }
};

/// Value of a map that may be absent.
SEAMOUNT_INLINE float value_or_one(const ScalarField& map, size_t cell) {
  return map.empty() ? 1.0F : map.data()[cell];
}

class Beds;

/// Where and how fast a terrain wears and rises, each empty where it was not given.
struct Maps {
  ScalarField hardness;        ///< how many times as hard as the erodibility says; > 0
  Mask mask;                   ///< where erosion acts: 0 nowhere, 1 fully
  ScalarField uplift;          ///< share of the uplift
  ScalarField rain;            ///< share of the rain; > 0
  const Beds* beds = nullptr;  ///< what lies under each cell, in three dimensions (beds.h); the map is times theirs

  /// What a cell rises when the land rises by `uplift_m`.
  float rise(size_t cell, float uplift_m) const {
    return uplift_m * value_or_one(uplift, cell) * value_or_one(mask, cell);
  }
};

/// Volumes in m3, added up over a run. Eroded is what water, waves and failing slopes picked up, most of it more than
/// once; what slides from cell to cell is none of it.
struct Ledger {
  double uplifted = 0;
  double exported = 0;
  double eroded = 0;
  double deposited = 0;
};

}  // namespace seamount::erosion
