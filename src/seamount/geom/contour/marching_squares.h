// Marching squares for all levels at once, as chains of points; contour.h makes areas, lines and contours of them.
#pragma once

#include <span>
#include <vector>

#include "seamount/geom/contour/chains.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// How the field goes on beyond the outermost centres: constant up to the frame's edge, where contours end (open) or
/// run along the edge, all at the same place (closed); or from there falling below every level within one cell, so that
/// contours close there without touching (apron).
enum class FieldEdge { open, closed, apron };

/// REQUIRES: levels ascend strictly. Values that are not numbers count as below everything. Chains in the order of
/// their first square, row by row; higher ground on the left.
std::vector<ContourChain> march_squares(const ScalarField& field, std::span<const double> levels, FieldEdge edge,
                                        const RunContext& run);

}  // namespace seamount::geom
