// Label maps without specks.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/label_map.h"

namespace seamount::classify {

/// Gives patches (cells of one label that touch along sides) of fewer than `min_cells` cells the label that most of the
/// cells around them have, if those lie on the same side of the coast (mountain and beach are land); ties to the
/// smaller label. A patch that is an island or a lake of its own stays. Serial, linear.
void remove_patches(LabelMap& labels, int64_t min_cells, const RunContext& run);

}  // namespace seamount::classify
