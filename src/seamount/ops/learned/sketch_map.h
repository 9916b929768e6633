// From what was drawn, in whatever form, to the cells that a network sees.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/ops/learned/sketch.h"
#include "seamount/ops/learned/sketch_planes.h"

namespace seamount::learned {

/// Lines become cells one wide, heights discs of a cell, areas high ground (and all else low). low_m and relief_m
/// follow the parameters or, where they are absent, what was drawn with heights. Lines and heights beside the frame
/// are said. Throws InvalidArgument where all are, and for `erase` without terrain; IncompatibleInputs for grids of
/// another size.
SketchMap map_of(const SketchInputs& inputs, const SketchParams& params, const GridFrame& frame, const RunContext& run);

}  // namespace seamount::learned
