// Between which heights each region of a grown network lies.
//
// Regions are numbered by level: a hill's is one above its parent's, a basin's one below. A region of level k spans the
// keys [k, k + 1]; a hill's outline lies at key k, a basin's at k + 1. Regions that no outline of given height parts
// from each other are a group, in which a key has one height: given, or where the distribution puts it (P2 sec. 4.4).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "seamount/model/tin.h"
#include "seamount/ops/contour/heights/heights_params.h"

namespace seamount::contour {

struct RegionBand {
  int level = 0;
  int group = 0;
  double from_m = 0.0;     ///< lowest height: a hill's outline, a basin's floor
  double to_m = 0.0;       ///< highest height: of the highest outline inside, a basin's outline, or the summit
  double outline_m = 0.0;  ///< of its outline
  bool summit = false;     ///< no hill stands in it
  bool alone = false;      ///< the outlines in it have heights of their own, so that it does not rise with its group
};

/// One band per region. `nodes`: how many lie in each. Throws InvalidArgument{"max_m" or "min_m"} where an outline's
/// height leaves the distribution's range. n log n in regions.
std::vector<RegionBand> height_bands(const std::vector<TinRegion>& regions, std::span<const int64_t> nodes,
                                     const HeightDistribution& distribution, const HeightsParams& params);

}  // namespace seamount::contour
