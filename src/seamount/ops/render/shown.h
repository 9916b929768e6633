// What a picture shows besides the ground itself.
#pragma once

#include "seamount/model/areas.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"
#include "seamount/model/things.h"

namespace seamount::render {

/// All of the terrain's size and in its system; each may be null.
struct Shown {
  const LabelMap* labels = nullptr;   ///< where beach, lagoon and reef are
  const Things* things = nullptr;     ///< what stands on the terrain
  const ScalarField* lake = nullptr;  ///< metres of standing water over it, each lake with a surface of its own
  const Drawing* rivers = nullptr;    ///< lines of running water, as wide as they say (width_m, order)
};

}  // namespace seamount::render
