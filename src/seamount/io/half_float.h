// Numbers of 16 bits as files of weights hold them: IEEE half precision (f16) and the upper half of an f32 (bf16).
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace seamount::io {

/// Exact.
inline float from_bf16(uint16_t bits) { return std::bit_cast<float>(static_cast<uint32_t>(bits) << 16); }

/// Exact; infinities and what is no number stay so.
inline float from_f16(uint16_t bits) {
  const uint32_t sign = (bits & 0x8000U) << 16, rest = bits & 0x7fffU;
  if (rest >= 0x7c00) return std::bit_cast<float>(sign | 0x7f800000U | (rest & 0x3ffU) << 13);
  if (rest < 0x400) return (sign != 0 ? -1.0F : 1.0F) * static_cast<float>(rest) * 0x1p-24F;
  return std::bit_cast<float>(sign | ((rest << 13) + (112U << 23)));
}

/// Rounded to nearest, ties to even; infinite from 65520 on. REQUIRES: a number.
inline uint16_t to_f16(float value) {
  const uint32_t bits = std::bit_cast<uint32_t>(value), size = bits & 0x7fffffffU;
  const auto sign = static_cast<uint16_t>(bits >> 16 & 0x8000U);
  if (size >= std::bit_cast<uint32_t>(65520.0F)) return sign | 0x7c00U;
  // Below 2^-14 all steps are 2^-24.
  if (size < std::bit_cast<uint32_t>(0x1p-14F))
    return sign | static_cast<uint16_t>(std::nearbyint(std::bit_cast<float>(size) * 0x1p24F));
  return sign | static_cast<uint16_t>((size - (112U << 23) + 0xfffU + (size >> 13 & 1U)) >> 13);
}

}  // namespace seamount::io
