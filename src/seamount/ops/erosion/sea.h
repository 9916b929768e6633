// What is sea to erosion: ground below its level, but for hollows of the land (geom/water/inland.h), which are ground
// like any other and whose water stands as a lake or runs over their rim.
#pragma once

#include <cstdint>

#include "seamount/model/grid.h"

namespace seamount::erosion {

struct Sea {
  float level_m = 0;
  const Grid<uint8_t>* hollows = nullptr;  ///< 1: no sea, whatever its height; empty or nullptr: there are none

  bool covers(size_t cell, float height_m) const {
    return height_m < level_m && (hollows == nullptr || hollows->empty() || hollows->data()[cell] == 0);
  }
  /// Of the water over ground; 0 on land.
  float depth(size_t cell, float height_m) const { return covers(cell, height_m) ? level_m - height_m : 0.0F; }
};

}  // namespace seamount::erosion
