// How far contours are pushed across the disc of a tool: the displacement functions delta of P2 sec. 5.2 and 5.3 and
// appendices A and B, scaled so that delta(1/2) = 1, and what keeps the maps made of them one to one.
#pragma once

#include <vector>

#include "seamount/model/drawn.h"

namespace seamount::contour {

/// The largest segment epsilon for which P2's delta(x) = epsilon (4 x (1 - x))^k / (2 r) keeps delta' >= -1:
/// 2 r sqrt(2 k - 1) (4 k - 2)^(k - 1) / (4^k k (k - 1)^(k - 1)), that is 0.5 r, 0.64 r, 0.58 r for k = 1, 2, 3.
/// REQUIRES: k >= 1.
double longest_segment(double radius_m, int k);

/// A displacement function on [0, 1] with value 0 at both ends and 1 in the middle.
class Displacement {
 public:
  /// (4 x (1 - x))^k. REQUIRES: k >= 1.
  explicit Displacement(int k);

  /// A drawn function (appendix B), monotone cubic between knots, scaled so that its middle is 1. Throws
  /// InvalidArgument{name} unless its knots lie in [0, 1] with values in [0, 1], it is 0 at 0 and 1 and above 0 in the
  /// middle.
  explicit Displacement(const Curve& drawn, const char* name);

  double operator()(double x) const;

  /// -min of the derivative: epsilon <= 2 r / steepest_fall() keeps the drag along a segment one to one.
  double steepest_fall() const { return steepest_fall_; }

  /// k, or 2 for a drawn one: how softly the drag ends to the sides.
  int softness() const { return k_ > 0 ? k_ : 2; }

 private:
  int k_ = 0;                  ///< 0: drawn
  std::vector<double> table_;  ///< of a drawn one, read linearly
  double steepest_fall_ = 0.0;
};

}  // namespace seamount::contour
