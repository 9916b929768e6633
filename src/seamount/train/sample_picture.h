// Pictures of a training's samples, to look at.
#pragma once

#include <string>
#include <vector>

#include "seamount/train/sample.h"

namespace seamount::train {

/// One row of relief shadings: what was drawn (rivers blue, ridges red, the base behind), what the network made, what
/// is real; four samples beside each other. `sketched`: planes are as of learned::SketchPlanes;
/// else nothing is drawn over the base. Throws
/// WriteError.
void write_sample_picture(const std::vector<Sample>& samples, bool sketched,
                          const std::vector<std::vector<float>>& made, const std::string& path);

}  // namespace seamount::train
