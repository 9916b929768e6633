// How rough terrains of learned.sketch are drawn again: by sketch.extract, which is of another family than the
// networks.
#pragma once

#include "seamount/ops/learned/sketch_guide.h"

namespace seamount::recipe {

/// A learned::Redraw.
Drawing draw_again(const HeightField& terrain, double least_m2, Seed seed, const RunContext& run);

}  // namespace seamount::recipe
