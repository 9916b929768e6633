// Learning a dictionary for amplify.sparse from real ground.
//
// Pieces of the ground are looked at as they are and with cells of twice the size, so that a dictionary knows detail of
// two scales: coarse cells are means of four, detail is the ground less the coarse cells refined. Sea, unknown cells
// and ground whose detail is below what its heights were rounded to are passed over. Pieces that look alike (k-means of
// their shapes) are stood for by one of them: of the half nearest to their mean, the one whose detail is as strong as
// theirs on average. A mean of details would blunt every crest. At last all details are scaled so that the ground,
// coarsened and amplified again, has as much of it as it had: where neighbouring atoms disagree, blending takes some.
#pragma once

#include <span>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/amplify/dictionary.h"

namespace seamount::train {

struct DictionaryParams {
  int atoms = 2048;
  int pieces = 100000;
  double least_detail_m = 0.8;

  static constexpr auto fields() {
    using P = DictionaryParams;
    return std::tuple(
        field(&P::atoms, "atoms", "", between(16, amplify::kMostAtoms), "atoms at most; few groups may be empty"),
        field(&P::pieces, "pieces", "", between(64, 2000000), "pieces of ground that are looked at"),
        field(&P::least_detail_m, "least_detail_m", "m", between(0, 100),
              "root of the mean square of a piece's detail below which it is noise"));
  }
};

struct LearnedDictionary {
  amplify::Dictionary dictionary;
  int64_t pieces = 0;  ///< that had detail
  double scale = 1.0;  ///< what details were multiplied with at last
};

/// Heights of square cells; NaN where unknown. Throws InvalidArgument for params out of range, Error where the grounds
/// have too little land with detail. Parallel; about 5 s for 2048 atoms and a ground of 3000 x 3000 cells.
LearnedDictionary learn_dictionary(std::span<const HeightField> grounds, const DictionaryParams& params, Seed seed,
                                   const RunContext& run);

}  // namespace seamount::train
