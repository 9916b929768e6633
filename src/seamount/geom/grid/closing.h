// Grey closing: thin dark lines vanish, everything broader stays as it is, edges included.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// The highest value within `reach` cells (a square), then the lowest of those (Serra 1982). What is low over fewer
/// than 2 reach + 1 cells across takes the value beside it. Parallel; linear in cells times reach.
ScalarField closing(const ScalarField& field, int reach, const RunContext& run);

}  // namespace seamount::geom
