// Extrapolation of a terrain beyond what is known of it: ground that falls gently and smoothly from the known part's
// border, by Poisson's equation.
#pragma once

#include <cstdint>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Replaces heights where covered == 0 by the solution of laplace(u) = constant that meets the covered ones, the
/// constant such that the new ground falls away from them by `slope` (m/m) on average; no flux through the grid's edge.
/// It bends evenly, so that no creases show as they do where each cell takes the nearest height. Solved on at most 512
/// cells across, then fitted to the border. Throws IncompatibleInputs where no cell is covered. Linear, parallel; two
/// more copies of the grid.
void extrapolate_ground(HeightField& heights, const Grid<uint8_t>& covered, double slope, const RunContext& run);

}  // namespace seamount::geom
