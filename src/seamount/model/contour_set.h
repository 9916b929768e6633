// A terrain as nested iso-contours (P2 sec. 3.1).
#pragma once

#include <vector>

#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount {

/// One closed contour. Higher ground is on its left: counter-clockwise around a hill, clockwise around a basin.
struct Contour {
  double height_m = 0.0;
  Ring ring;        ///< simple; at least three points
  int parent = -1;  ///< index of the contour that directly encloses it; -1: none
  bool operator==(const Contour&) const = default;
};

/// Contours never cross or touch each other or themselves, and parents stand before children. Land that reaches the
/// frame's edge is closed a little beyond it.
struct ContourSet {
  GridFrame frame;  ///< the document's frame, in whose coordinates the rings are
  std::vector<Contour> contours;
  bool operator==(const ContourSet&) const = default;
};

}  // namespace seamount
