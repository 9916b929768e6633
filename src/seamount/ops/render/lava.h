// Where lava runs on a volcano: from the outbreaks in the high layer down the valleys, in streams that grow where they
// join and cool on their way.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/geom/grid/height_layers.h"
#include "seamount/model/grid.h"

namespace seamount::render {

/// How much lava runs at each cell, 0 to 1. `vents` is where it comes from (weights); streams have cooled at a height
/// of `foot_m`, from three times that height on. Follows steepest descent over the filled terrain (geom/water/flow.h)
/// on at most 1024 cells a side; only the largest streams run, what cools stops. Parallel but for flow in flats; about
/// 100 ns a cell of that size.
Mask lava_streams(const HeightField& terrain, const Mask& vents, const geom::Borders& borders, const RunContext& run);

}  // namespace seamount::render
