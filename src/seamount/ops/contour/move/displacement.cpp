#include "seamount/ops/contour/move/displacement.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/scalar/curve.h"

namespace seamount::contour {
namespace {

constexpr int kSteps = 1024;

double power(double x, int n) {
  double result = 1.0;
  for (int i = 0; i < n; ++i) result *= x;
  return result;
}

void check_drawn(const Curve& drawn, const char* name) {
  for (const Knot& knot : drawn.knots) {
    if (!(knot.x >= 0.0 && knot.x <= 1.0))
      throw InvalidArgument(name,
                            "x = " + format_number(knot.x) + " is outside [0, 1], from the disc's rim to its rim");
    if (!(knot.y >= 0.0 && knot.y <= 1.0))
      throw InvalidArgument(name, format_number(knot.y) + " at x = " + format_number(knot.x) + " is outside [0, 1]");
  }
}

}  // namespace

double longest_segment(double radius_m, int k) {
  // ((4 k - 2) / (k - 1))^(k - 1) / 4^k, factor by factor so that nothing overflows; 0^0 = 1 at k = 1.
  double factor = 0.25;
  for (int i = 1; i < k; ++i) factor *= (4.0 * k - 2.0) / (4.0 * (k - 1.0));
  return 2.0 * radius_m * std::sqrt(2.0 * k - 1.0) * factor / k;
}

Displacement::Displacement(int k) : k_(k), steepest_fall_(2.0 / longest_segment(1.0, k)) {}

Displacement::Displacement(const Curve& drawn, const char* name) {
  check_drawn(drawn, name);
  const geom::CurveFunction function(drawn, geom::CurveKind::monotone_cubic, name);
  const double middle = function(0.5);
  if (function(0.0) != 0.0 || function(1.0) != 0.0)
    throw InvalidArgument(name, "is " + format_number(function(0.0)) + " at 0 and " + format_number(function(1.0)) +
                                    " at 1; it must be 0 at both ends, or space tears at the disc's rim");
  if (!(middle > 0.0)) throw InvalidArgument(name, "is 0 in the middle; it must be above 0 at x = 0.5");
  table_.resize(kSteps + 2, 0.0);
  for (int i = 0; i <= kSteps; ++i) table_[static_cast<size_t>(i)] = function(static_cast<double>(i) / kSteps) / middle;
  for (size_t i = 0; i < kSteps; ++i) steepest_fall_ = std::max(steepest_fall_, (table_[i] - table_[i + 1]) * kSteps);
}

double Displacement::operator()(double x) const {
  if (k_ > 0) return power(4.0 * x * (1.0 - x), k_);
  const double t = std::clamp(x, 0.0, 1.0) * kSteps;
  const auto i = static_cast<size_t>(t);
  return table_[i] + (t - static_cast<double>(i)) * (table_[i + 1] - table_[i]);
}

}  // namespace seamount::contour
