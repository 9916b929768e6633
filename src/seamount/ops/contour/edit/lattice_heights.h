// Heights between contours on a lattice, for tools that make contours anew within an outline.
//
// Heights solve the Laplace equation between contours. Lattice nodes next to a contour are given their height from
// their distance to it and the slope there, so contours of the lattice lie where the given ones do, not on its steps;
// and always on the side of each contour on which the node lies, so that the lattice knows the same bands. Summits,
// hollows and saddles are no flats: they go on at the slope around them, up to less than the gap between levels.
#pragma once

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/grid.h"

namespace seamount::contour {

/// A line of one height, higher ground on its left.
struct LevelLine {
  const Polyline* points;
  double height_m;
  bool closed;
};

std::vector<LevelLine> level_lines(const ContourSet& set);
std::vector<LevelLine> level_lines(const Drawing& pattern);

/// Heights at the frame's cell centres. `gap_m`: the least difference between the lines' heights. Where no line comes
/// into the frame all is `without`. Parallel; about 20 solver steps a node and linear in the points of the lines.
ScalarField lattice_heights(const std::vector<LevelLine>& lines, const GridFrame& frame, double gap_m, double without,
                            const RunContext& run);

}  // namespace seamount::contour
