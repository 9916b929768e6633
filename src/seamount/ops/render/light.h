// How much light reaches each cell of a height field: cast shadows of a soft sun, and the open part of the sky.
//
// Shadows: along parallel lines towards the sun a shadow's height falls by tan(elevation) a metre, so one sweep over
// the rows gives the shadow of one sun direction exactly, linearly in cells. A soft sun is a few such directions. Sky:
// horizon angles in 16 directions, each from samples at doubling distances of ever smoother terrain (the distance
// pyramid of screen-space ambient occlusion, here in the ground plane, where it has no view-dependent faults).
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::render {

/// Where the sun stands: bearing clockwise from north and height above the horizon, radians.
struct SunDirection {
  double azimuth = 0.0;
  double elevation = 0.5;
};

/// The lit share of the sun at every cell in [0, 1]. `softness` is the half width of the sun's disc in radians.
/// Parallel; about 2 ns a cell and direction, three more grids of memory.
Grid<float> sun_visibility(const HeightField& surface, SunDirection sun, double softness, const RunContext& run);

/// How a cell lies in its surroundings.
struct Openness {
  Grid<float> sky;        ///< cosine-weighted share of the sky that is not hidden, (0, 1]
  Grid<float> concavity;  ///< mean height around minus own height over the radius, at about 2 % of the larger side:
                          ///< positive in valleys, negative on ridges
};

/// Parallel; about 40 ns a cell, so callers reduce() large terrains first. Ten grids of memory.
Openness openness(const HeightField& surface, const RunContext& run);

/// Means of 2 x 2 cells, again and again until both sides are at most `limit`; the frame keeps its corner. Cells beyond
/// an odd edge repeat the last one. A copy where nothing is to be done.
HeightField reduce(const HeightField& surface, int limit, const RunContext& run);

}  // namespace seamount::render
