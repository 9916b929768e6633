// Water behind a belt of reefs: the lagoon of a barrier reef that is a row of separate reefs with passes between them,
// as off Cairns, where it is 50 km wide and open to all winds that blow along it.
#pragma once

#include <cstdint>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::classify {

struct Belt {
  double bar_m = 6.0;        ///< ground that is shallower is a bar, or land
  double platform_m = 80.0;  ///< depth of the platform on which the belt stands
  double gap_m = 20000.0;    ///< bars that are as near to one another are linked, where all between them is platform
  double open = 0.2;         ///< share of ways to the deep with which water still lies behind the belt
};

/// 1 on the platform where bars and their links stand between water and the deep: of 16 ways, straight on until they
/// meet a bar, a link, the deep (ground below the platform) or the frame's edge, at least three end at bars or links
/// with the deep beyond, and of those that do not end at the edge at most the share `open` in the deep. Bars that hang
/// together with more than 20 km2 of land are coast, no belt; coasts are not linked with one another. Linear in the
/// cells and in the links.
Grid<uint8_t> behind_belt(const HeightField& terrain, const Belt& belt, const RunContext& run);

}  // namespace seamount::classify
