// From the cells of a coarse terrain to strokes of a hand: smooth, in the valley or on the crest, and not along the
// grid.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/ops/sketch/courses.h"
#include "seamount/ops/sketch/ground.h"

namespace seamount::sketch {

/// Trees of places, each joined by a straight line to the one downstream (-1 at ends).
struct Strokes {
  std::vector<Vec2> places;
  std::vector<int32_t> down;
};

/// Through the middles of the courses' cells, half a cell apart, drawn smooth (a Gaussian along the line of about a
/// cell) and towards the lowest place across it (the highest for ridges) on the coarse surface, at most a cell away.
/// Where lines join they stay joined. Rivers are led on to the coast, or to the edge of the terrain. Linear.
Strokes draw_strokes(const Courses& courses, const HeightField& coarse, const Ground& ground, bool ridges,
                     double flat_m);

}  // namespace seamount::sketch
