// Smooth steps, maxima and minima of heights (P0 sec. 1.4.2, eq. 1.9 and 1.12-1.15).
//
// The mean of P0's smax- and smax+ is a + d / (1 - exp(-2 k d)) with d = b - a, which is max(a, b) + B(2 k |d|) / (2 k)
// with B(u) = u / (exp(u) - 1): symmetric, smooth, never below max(a, b) and above it by at most 1 / (2 k).
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#include "seamount/base/simd.h"

namespace seamount::geom {

/// 3 x^2 - 2 x^3 on [0, 1], constant beyond (eq. 1.9).
inline double smoothstep(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

SEAMOUNT_INLINE float smoothstep(float x) {
  const float t = x < 0.0F ? 0.0F : (x > 1.0F ? 1.0F : x);
  return t * t * (3.0F - 2.0F * t);
}

/// Smooth maximum; 1 / (2 k) above both where they are equal. REQUIRES: k > 0 (1 / unit of a), finite a and b.
inline double smax(double a, double b, double k) {
  const double u = 2.0 * k * std::abs(a - b);
  return std::max(a, b) + (u > 0.0 ? u / std::expm1(u) : 1.0) / (2.0 * k);
}

/// Smooth minimum, -smax(-a, -b).
inline double smin(double a, double b, double k) { return -smax(-a, -b, k); }

namespace detail {
/// B(u) = u / (exp(u) - 1) for u >= 0 by exp(u) - 1 = 2^n (exp(r) - 1) + (2^n - 1), |r| <= ln 2 / 2: no cancellation
/// near 0, relative error below 1e-6, 0 (to float's last digits) for large u.
SEAMOUNT_INLINE float bernoulli(float u) {
  u = u > 1e-20F ? (u < 80.0F ? u : 80.0F) : 1e-20F;
  const int32_t n = static_cast<int32_t>(u * 1.44269504F + 0.5F);
  const float fn = static_cast<float>(n);
  const float r = (u - fn * 0.693145752F) - fn * 1.42860677e-6F;
  const float p =
      1.0F + r * (0.5F + r * (0.166666667F + r * (0.0416666667F + r * (0.00833333333F + r * 0.00138888889F))));
  const float scale = std::bit_cast<float>((n + 127) << 23);
  return u / (scale * (r * p) + (scale - 1.0F));
}
}  // namespace detail

/// The same in float, about 1e-6 / k exact, for loops that the compiler vectorises.
SEAMOUNT_INLINE float smax(float a, float b, float k) {
  const float difference = a - b;
  const float larger = difference > 0.0F ? a : b;
  const float distance = difference > 0.0F ? difference : -difference;
  return larger + detail::bernoulli(2.0F * k * distance) / (2.0F * k);
}

SEAMOUNT_INLINE float smin(float a, float b, float k) { return -smax(-a, -b, k); }

/// out[i] = smax(a[i], b[i], k), vectorised. REQUIRES: equal sizes; out may be a or b itself.
void smax_rows(std::span<const float> a, std::span<const float> b, float k, std::span<float> out);

/// out[i] = smin(a[i], b[i], k), vectorised. REQUIRES: equal sizes; out may be a or b itself.
void smin_rows(std::span<const float> a, std::span<const float> b, float k, std::span<float> out);

}  // namespace seamount::geom
