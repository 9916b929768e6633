// Pieces of ground: the shape of coarse cells and the detail that the ground has there.
#pragma once

#include <span>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/amplify/dictionary.h"

namespace seamount::train {

struct Piece {
  amplify::Features shape;
  amplify::Detail detail;
  float strength;  ///< root of the mean square of the detail
};

/// At most `count` pieces from places that the seed draws, each ground as often as any other, two thirds as it is and
/// one third with cells of twice the size. Those are missing where sea, unknown cells or too little detail are, and the
/// 4 % whose detail is strongest for their relief: errors of the data, which would stand out as pimples. Parallel.
std::vector<Piece> draw_pieces(std::span<const HeightField> grounds, int count, double least_detail_m, Seed seed,
                               const RunContext& run);

}  // namespace seamount::train
