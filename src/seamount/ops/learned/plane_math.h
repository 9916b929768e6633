// Functions that rows of planes are made of, for loops of vectors. In f32, right to 4e-7 of 1 or of the value (exp of
// large numbers to 4e-6), which the networks' bf16 does not see.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "seamount/base/simd.h"

namespace seamount::learned {

/// exp(x) for x in [-80, 80]; the nearer end's beyond.
SEAMOUNT_INLINE float fast_exp(float x) {
  constexpr float kRound = 12582912.0F;  // 1.5 2^23: sums with it are whole numbers
  const float t = 1.44269504F * std::min(80.0F, std::max(-80.0F, x)), sum = t + kRound;
  const int32_t whole = std::bit_cast<int32_t>(sum) - std::bit_cast<int32_t>(kRound);
  const float r = t - (sum - kRound);  // 2^r, |r| <= 1/2, by the series of exp(r log 2)
  const float power =
      1.0F + r * (0.69314718F +
                  r * (0.24022651F + r * (0.05550411F + r * (0.00961813F + r * (0.00133336F + r * 0.00015404F)))));
  return power * std::bit_cast<float>((whole + 127) << 23);
}

/// Natural logarithm of x >= 1.2e-38, finite.
SEAMOUNT_INLINE float fast_log(float x) {
  const auto bits = std::bit_cast<int32_t>(x);
  const int32_t above = (bits - 0x3f3504f3) >> 23;  // x = m 2^above, m from sqrt(1/2) to sqrt(2)
  const float m = std::bit_cast<float>(bits - above * (1 << 23));
  const float s = (m - 1) / (m + 1), q = s * s;  // 2 atanh(s)
  return 0.69314718F * static_cast<float>(above) +
         2 * s * (1 + q * (0.33333333F + q * (0.2F + q * (0.14285714F + q * 0.11111111F))));
}

SEAMOUNT_INLINE float fast_tanh(float x) { return std::copysign(1 - 2 / (fast_exp(2 * std::abs(x)) + 1), x); }

/// |x| < 1e18.
SEAMOUNT_INLINE float fast_asinh(float x) { return std::copysign(fast_log(std::abs(x) + std::sqrt(x * x + 1)), x); }

}  // namespace seamount::learned
