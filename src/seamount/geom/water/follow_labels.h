// Labels of a terrain that has changed: what was beach, lagoon or reef, where the sea lies elsewhere than before.
//
// Land is beach or mountain, sea is lagoon, reef or abyss. How wide and how high beaches are is read off the labels
// before; where that zone moves the beach moves with it, and what it leaves is mountain. A lagoon or reef that filled
// up is land. Land that drowned is lagoon, or abyss where the nearest water is.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"

namespace seamount::geom {

/// The labels of `after`. A cell keeps its region where it fits what the cell is and neither its side of the coast nor
/// its being in reach of a beach has changed. Sea is what find_hollows() (inland.h) leaves at or below sea_m. REQUIRES:
/// the same frames. Parallel but for the distances; about 40 ns per cell, 20 bytes.
LabelMap follow_labels(const LabelMap& labels, const HeightField& before, const HeightField& after, float sea_m,
                       const RunContext& run);

/// Labels of a terrain of which none are known: mountain on land, abyss in the sea.
LabelMap plain_labels(const HeightField& terrain, float sea_m, const RunContext& run);

}  // namespace seamount::geom
