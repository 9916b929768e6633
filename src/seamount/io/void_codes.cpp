#include "seamount/io/void_codes.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/base/text.h"

namespace seamount::io {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr float kHuge = 1e30F;  ///< beyond it is 3.4e38 or what arithmetic made of it

struct Code {
  float value;
  int64_t cells = 0;
  int64_t near = 0;  ///< other values that come near it
};

std::string cells_text(int64_t count) { return std::to_string(count) + (count == 1 ? " cell" : " cells"); }

}  // namespace

void take_out_void_codes(Grid<float>& stored, const std::string& name, bool heights, const RunContext& run) {
  constexpr float kNear = 500.0F;
  std::array<Code, 9> codes{{{-9999}, {-32768}, {-32767}, {32767}, {-99999}, {9999}, {99999}, {-999999}, {999999}}};
  int64_t huge = 0;
  float first_huge = 0;
  for (const float z : stored.cells()) {
    if (!(std::abs(z) >= 9999 - kNear)) continue;
    if (std::abs(z) > kHuge) {  // infinite ones too
      if (huge++ == 0) first_huge = z;
      continue;
    }
    for (Code& code : codes) {
      if (z == code.value)
        ++code.cells;
      else if (std::abs(z - code.value) < kNear)
        ++code.near;
    }
  }
  bool any = huge > 0;
  for (Code& code : codes) {
    // -32768 and -32767 are near each other and both codes.
    if (code.value == -32768) code.near -= codes[2].cells;
    if (code.value == -32767) code.near -= codes[1].cells;
    if (code.near > 0 || (code.value > 0 && !heights)) code.cells = 0;
    any |= code.cells > 0;
  }
  if (!any) return;
  for (float& z : stored.cells()) {
    if (!(std::abs(z) >= 9999)) continue;
    bool code_of_none = std::abs(z) > kHuge;
    for (const Code& code : codes) code_of_none |= code.cells > 0 && z == code.value;
    if (code_of_none) z = kNone;
  }
  const auto say = [&](int64_t cells, float value) {
    if (cells > 0)
      run.say(name + ": " + cells_text(cells) + " of " + format_number(value) +
              ", a usual code for no data that the file does not declare: taken as cells without a value");
  };
  say(huge, first_huge);
  for (const Code& code : codes) say(code.cells, code.value);
}

void take_out_impossible_heights(Grid<float>& heights, const std::string& name, const RunContext& run) {
  constexpr float kMost = 30000.0F;  ///< metres; the highest mountain of Mars is 21 km
  int64_t impossible = 0, possible = 0;
  float worst = 0;
  for (const float z : heights.cells()) {
    if (std::abs(z) > kMost) {
      ++impossible;
      if (std::abs(z) > std::abs(worst)) worst = z;
    } else if (!std::isnan(z)) {
      ++possible;
    }
  }
  if (impossible == 0) return;
  if (impossible > possible)
    throw IoError(name, "most of its heights are more than 30 km from sea level, up to " + format_number(worst) +
                            " m: that is another unit or another coding (\"unit\", \"coding\", or low_m and high_m)");
  for (float& z : heights.cells())
    if (std::abs(z) > kMost) z = kNone;
  run.say(name + ": " + cells_text(impossible) + " of heights up to " + format_number(worst) +
          " m, which cannot be: taken as cells without a height");
}

}  // namespace seamount::io
