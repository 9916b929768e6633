// Curves as functions: a drawn Curve (model/drawn.h) evaluated exactly, or through a table in hot loops.
//
// Monotone cubic: Fritsch and Carlson, "Monotone piecewise cubic interpolation", 1980, with the harmonic mean slopes of
// Fritsch and Butland 1984: no overshoot, so a profile never leaves the range of its knots.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "seamount/base/simd.h"
#include "seamount/model/drawn.h"

namespace seamount::geom {

/// How a curve runs between its knots.
enum class CurveKind : uint8_t { monotone_cubic, linear };

/// A Curve as a function on all numbers: through every knot, constant beyond the first and the last.
class CurveFunction {
 public:
  /// Throws InvalidArgument{name} where there is no knot, a knot is not finite, or x does not ascend strictly; the
  /// message names the knot. Linear time.
  explicit CurveFunction(const Curve& curve, CurveKind kind = CurveKind::monotone_cubic,
                         std::string_view name = "curve");

  /// Logarithmic time in the number of knots.
  double operator()(double x) const;

  double first_x() const { return knots_.front().x; }
  double last_x() const { return knots_.back().x; }

 private:
  std::vector<Knot> knots_;
  std::vector<double> slopes_;
};

/// A function sampled evenly on [first, last], read by linear interpolation; constant beyond. For a function with
/// second derivative |f''| <= M the error is at most M step^2 / 8 and float rounding.
class CurveTable {
 public:
  /// REQUIRES: first < last, samples >= 2.
  CurveTable(const CurveFunction& function, double first, double last, int samples = 4096);

  SEAMOUNT_INLINE float operator()(float x) const {
    float t = (x - first_) * scale_;
    t = t > 0.0F ? (t < limit_ ? t : limit_) : 0.0F;
    const int32_t i = static_cast<int32_t>(t);
    return values_[static_cast<size_t>(i)] + (t - static_cast<float>(i)) * steps_[static_cast<size_t>(i)];
  }

  /// out[i] = (*this)(x[i]), vectorised. REQUIRES: equal sizes; out may be x.
  void evaluate(std::span<const float> x, std::span<float> out) const;

 private:
  float first_;
  float scale_;
  float limit_;
  std::vector<float> values_;
  std::vector<float> steps_;  ///< steps_[i] = values_[i + 1] - values_[i], 0 for the last
};

}  // namespace seamount::geom
