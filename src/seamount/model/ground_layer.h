// A layer of ground of a splat map: how much of each cell it takes.
#pragma once

#include <string>

#include "seamount/model/grid.h"

namespace seamount {

struct GroundLayer {
  std::string name;  ///< part of a file's name: "seabed"
  Mask weights;      ///< at least 0; those of all layers of a map sum to one
};

}  // namespace seamount
