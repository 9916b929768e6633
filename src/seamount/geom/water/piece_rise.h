// Ground that falls along its flow (tilt_flats()) across the borders of pieces of a raster (pieces.h).
//
// A cell that is not above where it flows to is raised to the next float above that, so along a way each cell is at
// least one float above the next. Counted in floats a rim cell lies at a height of its own, or so many above the cell
// beside the piece that its flow enters, whatever is higher: a graph of rims tells the heights of all.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"

namespace seamount::geom {

/// The number of a height among all floats, in their order; that of both zeros is 0. And back.
int32_t float_number(float height);
float float_of_number(int32_t number);

/// A rim cell, in numbers of floats.
struct RimRise {
  int32_t exit;   ///< the rim number over which its flow leaves the piece; -1: it ends in it
  int32_t steps;  ///< how many above what it enters then, at least
  int32_t least;  ///< the height that it has at least
};

/// By rim number. `codes`: directions in which rim cells may point out of the piece. Linear; 12 bytes a cell.
std::vector<RimRise> rim_rises(const HeightField& filled, const FlowDirections& codes, const RunContext& run);

}  // namespace seamount::geom
