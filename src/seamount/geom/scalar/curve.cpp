#include "seamount/geom/scalar/curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "seamount/base/error.h"
#include "seamount/base/text.h"

namespace seamount::geom {
namespace {

void check_knots(const Curve& curve, std::string_view name) {
  const std::string field(name);
  if (curve.knots.empty()) throw InvalidArgument(field, "has no knot; give at least one");
  for (size_t i = 0; i < curve.knots.size(); ++i) {
    const Knot& knot = curve.knots[i];
    const bool finite = std::isfinite(knot.x) && std::isfinite(knot.y);
    if (finite && (i == 0 || knot.x > curve.knots[i - 1].x)) continue;
    const std::string label =
        "knot " + std::to_string(i) + " (" + format_number(knot.x) + ", " + format_number(knot.y) + ")";
    if (!finite) throw InvalidArgument(field, label + " is not finite");
    throw InvalidArgument(field, label + " does not lie right of the knot before it at x = " +
                                     format_number(curve.knots[i - 1].x) + "; x must ascend");
  }
}

double secant(const Knot& a, const Knot& b) { return (b.y - a.y) / (b.x - a.x); }

/// Fritsch and Butland's weighted harmonic mean: 0 at extrema, never more than three times the smaller secant.
double inner_slope(const Knot& before, const Knot& at, const Knot& after) {
  const double left = secant(before, at);
  const double right = secant(at, after);
  if (left * right <= 0.0) return 0.0;
  const double h_left = at.x - before.x;
  const double h_right = after.x - at.x;
  const double w_left = 2.0 * h_right + h_left;
  const double w_right = h_right + 2.0 * h_left;
  return (w_left + w_right) / (w_left / left + w_right / right);
}

/// One-sided three-point slope at an end, limited so that the end segment stays monotone.
double end_slope(double h_near, double h_far, double near, double far) {
  const double slope = ((2.0 * h_near + h_far) * near - h_near * far) / (h_near + h_far);
  if (slope * near <= 0.0) return 0.0;
  if (near * far <= 0.0 && std::abs(slope) > 3.0 * std::abs(near)) return 3.0 * near;
  return slope;
}

std::vector<double> monotone_slopes(const std::vector<Knot>& knots) {
  const size_t n = knots.size();
  std::vector<double> slopes(n, 0.0);
  if (n < 2) return slopes;
  if (n == 2) {
    slopes[0] = slopes[1] = secant(knots[0], knots[1]);
    return slopes;
  }
  for (size_t i = 1; i + 1 < n; ++i) slopes[i] = inner_slope(knots[i - 1], knots[i], knots[i + 1]);
  slopes[0] = end_slope(knots[1].x - knots[0].x, knots[2].x - knots[1].x, secant(knots[0], knots[1]),
                        secant(knots[1], knots[2]));
  slopes[n - 1] = end_slope(knots[n - 1].x - knots[n - 2].x, knots[n - 2].x - knots[n - 3].x,
                            secant(knots[n - 2], knots[n - 1]), secant(knots[n - 3], knots[n - 2]));
  return slopes;
}

SEAMOUNT_VECTORISED void table_loop(const float* values, const float* steps, float first, float scale, float limit,
                                    const float* x, float* out, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    float t = (x[i] - first) * scale;
    t = t > 0.0F ? (t < limit ? t : limit) : 0.0F;
    const int32_t j = static_cast<int32_t>(t);
    out[i] = values[j] + (t - static_cast<float>(j)) * steps[j];
  }
}

}  // namespace

CurveFunction::CurveFunction(const Curve& curve, CurveKind kind, std::string_view name) {
  check_knots(curve, name);
  knots_ = curve.knots;
  if (kind == CurveKind::monotone_cubic) slopes_ = monotone_slopes(knots_);
}

double CurveFunction::operator()(double x) const {
  if (!(x > knots_.front().x)) return knots_.front().y;
  if (x >= knots_.back().x) return knots_.back().y;
  const auto after = std::upper_bound(knots_.begin(), knots_.end(), x, [](double v, const Knot& k) { return v < k.x; });
  const size_t i = static_cast<size_t>(after - knots_.begin()) - 1;
  const Knot& a = knots_[i];
  const Knot& b = knots_[i + 1];
  const double h = b.x - a.x;
  const double t = (x - a.x) / h;
  if (slopes_.empty()) return a.y + t * (b.y - a.y);
  const double s = 1.0 - t;
  const double value =
      s * s * (1.0 + 2.0 * t) * a.y + t * t * (3.0 - 2.0 * t) * b.y + h * t * s * (s * slopes_[i] - t * slopes_[i + 1]);
  return std::clamp(value, std::min(a.y, b.y), std::max(a.y, b.y));
}

CurveTable::CurveTable(const CurveFunction& function, double first, double last, int samples)
    : first_(static_cast<float>(first)),
      scale_(static_cast<float>((samples - 1) / (last - first))),
      limit_(static_cast<float>(samples - 1)),
      values_(static_cast<size_t>(samples)),
      steps_(static_cast<size_t>(samples), 0.0F) {
  assert(first < last && samples >= 2);
  for (size_t i = 0; i < values_.size(); ++i) {
    values_[i] = static_cast<float>(function(first + (last - first) * static_cast<double>(i) / (samples - 1)));
    if (i > 0) steps_[i - 1] = values_[i] - values_[i - 1];
  }
}

void CurveTable::evaluate(std::span<const float> x, std::span<float> out) const {
  assert(x.size() == out.size());
  table_loop(values_.data(), steps_.data(), first_, scale_, limit_, x.data(), out.data(), out.size());
}

}  // namespace seamount::geom
