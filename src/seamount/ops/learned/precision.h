// In what numbers a network is evaluated.
#pragma once

#include <array>
#include <string_view>

#include "seamount/base/fields.h"

namespace seamount::learned {

/// bf16 halves time and memory where the processor has it (AVX-512 BF16 or AMX); heights are summed in f32 in any case.
enum class Precision { automatic, f32, bf16 };

}  // namespace seamount::learned

template <>
struct seamount::Choices<seamount::learned::Precision> {
  static constexpr std::array<std::string_view, 3> names = {"automatic", "f32", "bf16"};
};
