// Where the lines of a sketch run on its coarse terrain: one way on from each cell, so that lines make trees.
//
// Many drops find many ways (stochastic_flow.h); here each cell passes its water on to the lower neighbour of its basin
// that most drops came through, and over the lowest pass where there is none. Lines are the cells that the rain of
// enough ground passes, from the first that lies in a valley of some depth on. Ways that cross diagonally are joined.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/sketch/stochastic_flow.h"

namespace seamount::sketch {

/// What runs on a coarse terrain. For ridges `surface` is the terrain turned upside down with a frame of walls.
struct Runoff {
  const HeightField& surface;
  const Grid<uint8_t>& starts;   ///< cells with rain, of the surface
  const Grid<uint32_t>& passed;  ///< drops, of the surface
  float sea_m, highest_pass_m;   ///< as for stochastic_flow()
  const HeightField& coarse;     ///< the terrain upright
  int frame_cells;               ///< by which the surface is wider on each side than `coarse`
  bool ridges;                   ///< lines on high ground, which may end anywhere; else in low, which reach an outlet
};

struct CourseParams {
  double least_cells = 2.0;   ///< of rain, for a line
  double flat_m = 1.0;        ///< a pit that is no deeper is no basin
  double stands_out_m = 1.0;  ///< what lies no deeper than the ground on both sides is no valley
  double least_length = 4.0;  ///< of a branch, in cells
  double leave = 0.3;         ///< share of the water that leaves a basin in which lines may end
  double basin_cells = 2.0;   ///< of rain that stays, for such a basin
  Grid<uint8_t> basins = {};  ///< cells of `coarse` where a pit may be one; empty: none
  Grid<uint8_t> rims = {};    ///< cells of `coarse` on which no line runs; empty: none
};

/// Cells of the coarse terrain, and for each the index of the one downstream; -1 at ends.
struct Courses {
  std::vector<int32_t> cells, down;
  std::vector<int32_t> basins;  ///< cells where lines, or most of their water, end
};

/// Cells come before those downstream of them. Linear; 60 bytes per cell.
Courses find_courses(const Runoff& runoff, const CourseParams& params, const RunContext& run);

}  // namespace seamount::sketch
