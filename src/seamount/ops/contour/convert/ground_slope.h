// How steep the ground about a place is, from the widths of the bands between contours: one field without jumps, which
// hangs continuously on the contours' points.
//
// A cell of a band of height I at distances d_k and d_{k+1} from its two contours tells I / (d_k + d_{k+1}). Cells
// beside a contour count, for they lie on its slope and not on a ridge or a valley floor, so much that every stretch of
// a contour weighs the same; those on the contour not at all, for which of two bands they lie in is a matter of
// rounding. What they tell is averaged over a few cells and, where there are none, over ever larger squares.
#pragma once

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/ops/contour/convert/face_ground.h"

namespace seamount::contour {

class GroundSlope {
 public:
  /// Parallel; linear. REQUIRES: the distances of `ground` are still there.
  GroundSlope(const FaceGround& ground, const RunContext& run);

  /// Metres a cell, over as many cells about as the nearest contour is away; 0 where no band has two bounds anywhere.
  float at(int x, int y, float near) const;

 private:
  struct Level {
    int width = 0, height = 0;
    std::vector<float> slopes, weights;  ///< sums of weighted slopes, at last slopes; of weights
    std::vector<float> known;            ///< how many cells told something
  };
  Level gather(const FaceGround& ground, const RunContext& run) const;
  static void soften(Level& level, const RunContext& run);
  static Level coarser(const Level& fine);

  std::vector<Level> levels_;  ///< squares of 2, 4, 8, ... cells
};

}  // namespace seamount::contour
