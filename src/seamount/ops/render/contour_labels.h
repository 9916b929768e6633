// Where a map of contours writes their heights: into straight stretches of the lines, apart from each other.
#pragma once

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"

namespace seamount::render {

/// A line in pixels that may carry its height.
struct LabelLine {
  const Ring* ring;
  double height_m;
  double width;  ///< of its label
};

struct ContourLabel {
  Vec2 at;
  Vec2 along;  ///< unit vector; text reads from left to right
  double height_m;
  double width;
};

/// The straightest stretches first; none that leaves the map, bends by more than a third of the text's height, or
/// comes near another label; labels of one height keep a greater distance. Linear in the points, but for the labels.
std::vector<ContourLabel> place_labels(const std::vector<LabelLine>& lines, double size_px, int width, int height,
                                       const RunContext& run);

}  // namespace seamount::render
