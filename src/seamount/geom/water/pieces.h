// Water across the borders of pieces of a raster that is too large for memory: what each piece must say of itself, so
// that a graph of their rims gives the same result, to the bit, as the whole would.
//
// Filling: Barnes 2016. A piece is flooded from its rim; cells that reach the rim at the same cell are a basin, and the
// lowest places between basins are the edges of a graph, as far as they are needed to join them all. Where that graph's
// basins overflow to the outside is the water level of their cells. Accumulation: Barnes 2017. What a piece gathers by
// itself, and where what enters it at a rim cell leaves it again, make a second graph.
//
// A rim is numbered along the first row, the last row, and the first and last cell of those between.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Cells on the rim of a piece.
int32_t rim_size(int width, int height);
/// The number of a rim cell; -1 for others.
int32_t rim_number(int x, int y, int width, int height);
/// The cell (row-major) of a rim number.
int32_t rim_cell(int32_t number, int width, int height);

/// Which sides of a piece are the whole raster's edge, over which water leaves.
struct OpenSides {
  bool west = false, north = false, east = false, south = false;
  bool at(int x, int y, int width, int height) const {
    return (west && x == 0) || (north && y == 0) || (east && x == width - 1) || (south && y == height - 1);
  }
};

/// A place between two basins of a piece, the lowest on the way from one to the other; basin 0 is the outside, others
/// are rim numbers + 1.
struct Spill {
  int32_t a, b;
  float height;
};

struct Flooded {
  HeightField filled;    ///< the lowest level from which water reaches the outside or the rim
  Grid<int32_t> basins;  ///< where it does
  std::vector<Spill> spills;
};

/// Floods a piece from the outside (the sea, at or below `sea_level_m`, and open sides) and from every other cell of
/// its rim: basins by steepest descent, joined over their passes. Parallel but for flats and passes; linear, n log n in
/// the passes; fewer spills than rim cells.
Flooded flood_piece(const HeightField& piece, float sea_level_m, const OpenSides& open, const RunContext& run);

/// Level at which each node overflows to node 0 over the spills, which are sorted: the lowest of the highest spills on
/// a way there; -infinity of node 0. Nodes without a way have +infinity.
std::vector<float> overflow_levels(int32_t nodes, std::vector<Spill> spills);

/// Waters of a piece: cells at or below the sea level that hang together by sides or corners.
struct PieceWater {
  int64_t cells = 0;
  float lowest = 0.0F;
  bool open = false;  ///< has a cell on the whole's edge, or an unknown one
};
struct PieceWaters {
  Grid<int32_t> of;  ///< number of the water of a cell, -1 for ground
  std::vector<PieceWater> all;
};
PieceWaters find_waters(const HeightField& piece, float sea_level_m, const OpenSides& open, const RunContext& run);

/// For each rim cell, the rim cell over which what enters there leaves the piece, or -1: it ends in it.
/// `codes`: directions in which rim cells may point out of the piece.
std::vector<int32_t> rim_exits(const FlowDirections& codes);

/// Cells that drain through each cell, with what enters at rim cells (by number) besides. Linear.
Grid<uint64_t> gather_piece(const FlowDirections& codes, const std::vector<uint64_t>& entering, const RunContext& run);

}  // namespace seamount::geom
