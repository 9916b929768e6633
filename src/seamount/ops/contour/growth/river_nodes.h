// Nodes of a network that lie on the beds of rivers: what rivers (rivers.h) tell growth (growth.h).
#pragma once

#include <cstdint>
#include <vector>

namespace seamount::contour {

struct RiverNodes {
  std::vector<int32_t> upstream;  ///< each after those that it flows to
  std::vector<int32_t> outlets;   ///< where rivers leave the domain
};

}  // namespace seamount::contour
