// Iso-contours of a scalar field by marching squares, as lines to draw and as areas to build on.
//
// The field is taken as linear between neighbouring cell centres and as constant over the half cell between the
// outermost centres and the frame's edge. At a saddle, a square with high corners across from each other and low ones
// between them, the high ground is joined if the mean of the four reaches the level. That is the same for every level,
// so contours of one field never cross.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// The area where value >= level: outer rings counter-clockwise, each with its holes (clockwise); the frame's edge
/// closes areas that reach it. Rings are simple and do not touch each other. In order of their first cell, row by row.
/// A value that is not a number counts as below. Linear in cells plus n log n in contour points.
std::vector<Polygon> trace_areas(const ScalarField& field, double level, const RunContext& run = {});

/// Contour lines for drawing, higher ground on the left; a closed line repeats its first point at the end, an open one
/// ends at the frame's edge. Same cost.
std::vector<Polyline> trace_lines(const ScalarField& field, double level, const RunContext& run = {});

/// The contours at all of the levels in one pass, closed, higher ground on the left, that neither cross nor touch each
/// other or themselves: beyond the frame's edge the field falls below every level within one cell, so that contours
/// which reach the edge close there, lower ones further out. Not nested yet (nesting.h). REQUIRES: levels ascend, no
/// two are the same, every value is finite. Linear in the cells (times the logarithm of the number of levels) and the
/// points.
std::vector<Contour> trace_contours(const ScalarField& field, std::span<const double> levels,
                                    const RunContext& run = {});

/// The area of cells with inside != 0, its stair steps smoothed away without moving the border further than one cell
/// anywhere. Oriented and nested like trace_areas.
std::vector<Polygon> trace_mask(const Grid<uint8_t>& inside, const RunContext& run = {});

}  // namespace seamount::geom
