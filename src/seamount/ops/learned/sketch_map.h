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

/// Cells that a line passes become 1. Returns whether any of it lies inside. Throws InvalidArgument{"lines"} for a line
/// longer than ten million cells.
bool draw_cells(const Polyline& line, Grid<uint8_t>& cells);

/// Makes the cell of a place a cue. Returns whether it lies inside.
bool put_height(Vec2 place, double height_m, SketchMap& map);

}  // namespace seamount::learned
