// Thin lines of thick ones, on grids and as chains of cells.
//
// Thinning: cells are peeled off in the order of their distance from the border as long as neither the number of pieces
// and holes changes (simple points of 8-connected figures, Kong and Rosenfeld 1989) nor an end is lost. Unlike the
// parallel rules of Zhang and Suen 1984 it never breaks or swallows a line, and what is left is one cell wide.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Replaces the cells with inside != 0 by their skeleton (1, else 0). Linear but for sorting by distance.
void thin(Grid<uint8_t>& inside, const RunContext& run);

/// A chain of neighbouring cells (row * width + column) between two places where lines end or meet; closed chains
/// repeat their first cell.
using CellChain = std::vector<int32_t>;

/// The chains of a skeleton in scan order of their first ends; every cell is in one of them, ends in several. A cell
/// alone is a chain of one. Linear.
std::vector<CellChain> trace_skeleton(const Grid<uint8_t>& skeleton);

/// Removes the branches with a free end that are shorter than min_branch cells, and then pieces of less than min_piece
/// cells in all. What remains is thinned again.
void prune_skeleton(Grid<uint8_t>& skeleton, int min_branch, int min_piece, const RunContext& run);

/// The middle of a chain's cells as a smooth line: every point stays within its own cell (less a tenth of it on each
/// side), the ends where they are.
Polyline smooth_chain(const CellChain& cells, const GridFrame& frame);

}  // namespace seamount::geom
