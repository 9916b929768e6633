// Numbers of 16 bits between layers: the upper half of an f32. Everything is computed in f32.
#pragma once

#include <bit>
#include <cstdint>

#include "seamount/base/simd.h"

namespace seamount::learned {

struct Bf16 {
  uint16_t bits;
};

SEAMOUNT_INLINE float number(float value) { return value; }
SEAMOUNT_INLINE float number(Bf16 value) { return std::bit_cast<float>(static_cast<uint32_t>(value.bits) << 16); }

/// Rounded to nearest, ties to even. REQUIRES: finite.
SEAMOUNT_INLINE void store(float value, float& to) { to = value; }
SEAMOUNT_INLINE void store(float value, Bf16& to) {
  const uint32_t bits = std::bit_cast<uint32_t>(value);
  to.bits = static_cast<uint16_t>((bits + 0x7fffU + (bits >> 16 & 1U)) >> 16);
}

}  // namespace seamount::learned
