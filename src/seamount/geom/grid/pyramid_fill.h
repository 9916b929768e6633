// Scattered values spread over a grid by a pyramid of means ("pull-push", Gortler et al. 1996): near them smooth and
// through them, far from them a prior. Linear in the cells and global, whatever lies between the values.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

struct PyramidFill {
  float prior = 0.0F;  ///< value far from every given one
  float fade =
      0.8F;  ///< what is left of a value's weight each time that cells double, (0, 1]; 1: it reaches everywhere
};

/// Values where weight is 1 stay as they are; where it is 0 they are replaced; in between they count in part. Values of
/// weight 0 may be anything, NaN as well. Without any weight all becomes the prior. Parallel; the same bytes on any
/// number of threads; three more grids of memory.
void pyramid_fill(ScalarField& values, Grid<float> weight, const PyramidFill& options, const RunContext& run);

}  // namespace seamount::geom
