#include "seamount/geom/scalar/point_source.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace seamount::geom {
namespace {

double polynomial(double t, std::initializer_list<double> coefficients) {  // lowest power first
  double sum = 0.0, power = 1.0;
  for (const double c : coefficients) {
    sum += c * power;
    power *= t;
  }
  return sum;
}

/// Modified Bessel function I0 for x <= 3.75 (Abramowitz and Stegun 9.8.1).
double bessel_i0_small(double x) {
  const double t = x / 3.75;
  return polynomial(t * t, {1.0, 3.5156229, 3.0899424, 1.2067492, 0.2659732, 0.0360768, 0.0045813});
}

}  // namespace

double bessel_k0(double x) {
  if (x <= 2.0) {
    const double t = 0.25 * x * x;
    return -std::log(0.5 * x) * bessel_i0_small(x) +
           polynomial(t, {-0.57721566, 0.42278420, 0.23069756, 0.03488590, 0.00262698, 0.00010750, 0.00000740});
  }
  return std::exp(-x) / std::sqrt(x) *
         polynomial(2.0 / x, {1.25331414, -0.07832358, 0.02189568, -0.01062446, 0.00587872, -0.00251540, 0.00053208});
}

double steady_point_source(double rate, double distance_m, double diffusivity_m2_s, double decay_per_s) {
  return rate / (2.0 * std::numbers::pi * diffusivity_m2_s) *
         bessel_k0(distance_m * std::sqrt(decay_per_s / diffusivity_m2_s));
}

double steady_gaussian_source(double rate, double distance_m, double diffusivity_m2_s, double decay_per_s,
                              double sigma_m) {
  // With s = sigma^2 / (2 D) + t = exp(q): the integrand is smooth in q and falls doubly exponentially for large q.
  const double begin = sigma_m * sigma_m / (2.0 * diffusivity_m2_s);
  const double from = std::log(begin), to = std::max(from, std::log(begin + 40.0 / decay_per_s));
  constexpr int kPieces = 400;  // Simpson's rule
  const double width = (to - from) / kPieces;
  double sum = 0.0;
  for (int i = 0; i <= kPieces; ++i) {
    const double s = std::exp(from + i * width);
    const double value = std::exp(-distance_m * distance_m / (4.0 * diffusivity_m2_s * s) - decay_per_s * (s - begin));
    sum += value * (i == 0 || i == kPieces ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0));
  }
  return rate / (4.0 * std::numbers::pi * diffusivity_m2_s) * sum * width / 3.0;
}

double released_unit(double x_m, double y_m, double seconds, double u_m_s, double v_m_s, double diffusivity_m2_s,
                     double decay_per_s) {
  const double dx = x_m - u_m_s * seconds, dy = y_m - v_m_s * seconds;
  const double spread = 4.0 * diffusivity_m2_s * seconds;
  return std::exp(-(dx * dx + dy * dy) / spread - decay_per_s * seconds) / (std::numbers::pi * spread);
}

}  // namespace seamount::geom
