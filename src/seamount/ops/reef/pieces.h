// Where a reef starts that nobody started: in each separate piece of its habitat.
#pragma once

#include <vector>

#include "seamount/base/rng.h"
#include "seamount/model/grid.h"
#include "seamount/ops/reef/aggregate.h"

namespace seamount::reef {

/// One cell of each piece of `habitat` (cells that touch, corners too) within each square of about 150 x 150 cells,
/// P4's lattice: nearest to the lattice's middle where it is one square, to a random place of its square where there
/// are more. Pieces of less than 4 cells have none, unless all are. At least one where there is habitat. Linear in
/// cells.
std::vector<LatticeCell> starts_of_pieces(const Grid<uint8_t>& habitat, Seed seed);

}  // namespace seamount::reef
