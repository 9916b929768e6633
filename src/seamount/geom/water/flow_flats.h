// Directions of flow over flats: Garbrecht and Martz 1997 in the linear form of Barnes, Lehman and Mulla 2014b.
#pragma once

#include <bit>
#include <cstdint>

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"

namespace seamount::geom {

/// Gives the cells without a lower neighbour (kPit) their directions: over their flat away from higher ground and,
/// twice as strongly, towards where it drains. A flat without outlet drains to its first cell, which stays kPit.
/// REQUIRES: steepest descent everywhere else; kPit neither on the border nor at sea. Flats side by side, each by one
/// thread; linear; 4 bytes per cell, and 14 per cell of the flats that are walked at the time.
void drain_flats(const HeightField& terrain, FlowDirections& directions, const RunContext& run);

/// Steepest descent alone: flats and floors stay kPit. Parallel, linear.
FlowDirections steepest_directions(const HeightField& terrain, float sea_level_m, const RunContext& run);

/// Over which of the neighbours where a flat drains, as bits by direction, a cell of it does. REQUIRES: there is one.
constexpr uint8_t first_outlet(unsigned outlets) {
  constexpr unsigned kStraight = 0b01010101;
  return static_cast<uint8_t>(std::countr_zero((outlets & kStraight) != 0 ? outlets & kStraight : outlets));
}

}  // namespace seamount::geom
