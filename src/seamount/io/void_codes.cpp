#include "seamount/io/void_codes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/base/text.h"

namespace seamount::io {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr float kHuge = 1e30F;   ///< beyond it is 3.4e38 or what arithmetic made of it
constexpr float kNear = 500.0F;  ///< of a code: what else comes so near makes a value of it
constexpr float kSmallest = 9999.0F;
constexpr float kMost = 30000.0F;  ///< metres; the highest mountain of Mars is 21 km

std::string cells_text(int64_t count) { return std::to_string(count) + (count == 1 ? " cell" : " cells"); }

}  // namespace

bool VoidCodes::candidate(float z) {
  if (!(std::abs(z) >= kSmallest)) return false;
  if (std::abs(z) > kHuge) return true;
  const VoidCodes any(true);
  return std::any_of(any.codes_.begin(), any.codes_.end(), [z](const Code& code) { return z == code.value; });
}

void VoidCodes::look(std::span<const float> stored) {
  for (const float z : stored) {
    if (!(std::abs(z) >= kSmallest - kNear)) continue;
    if (std::abs(z) > kHuge) {  // infinite ones too
      if (huge_++ == 0) first_huge_ = z;
      continue;
    }
    for (Code& code : codes_) {
      if (z == code.value)
        ++code.cells;
      else if (std::abs(z - code.value) < kNear)
        ++code.near;
    }
  }
}

void VoidCodes::settle() {
  for (Code& code : codes_) {
    // -32768 and -32767 are near each other and both codes.
    if (code.value == -32768) code.near -= codes_[2].cells;
    if (code.value == -32767) code.near -= codes_[1].cells;
    const bool is_value = code.near > 0 || (code.value > 0 && !heights_);
    code.kept = is_value ? code.cells : 0;
    if (is_value) code.cells = 0;
  }
}

int64_t VoidCodes::count() const {
  int64_t all = huge_;
  for (const Code& code : codes_) all += code.cells;
  return all;
}

void VoidCodes::take_out(std::span<float> stored) const {
  if (count() == 0) return;
  for (float& z : stored) {
    if (!(std::abs(z) >= kSmallest)) continue;
    bool code_of_none = std::abs(z) > kHuge;
    for (const Code& code : codes_) code_of_none |= code.cells > 0 && z == code.value;
    if (code_of_none) z = kNone;
  }
}

void VoidCodes::say(const std::string& name, const RunContext& run) const {
  const auto say = [&](int64_t cells, float value) {
    if (cells > 0)
      run.say(name + ": " + cells_text(cells) + " of " + format_number(value) +
              ", a usual code for no data that the file does not declare: taken as cells without a value");
  };
  say(huge_, first_huge_);
  for (const Code& code : codes_) say(code.cells, code.value);
}

void take_out_void_codes(Grid<float>& stored, const std::string& name, bool heights, const RunContext& run) {
  VoidCodes codes(heights);
  codes.look(stored.cells());
  codes.settle();
  codes.take_out(stored.cells());
  codes.say(name, run);
}

void ImpossibleHeights::look(float height, int64_t cells) {
  if (std::abs(height) > kMost) {
    impossible_ += cells;
    if (std::abs(height) > std::abs(worst_)) worst_ = height;
  } else if (!std::isnan(height)) {
    low_ = possible_ > 0 ? std::min(low_, height) : height;
    high_ = possible_ > 0 ? std::max(high_, height) : height;
    possible_ += cells;
  }
}

void ImpossibleHeights::settle(const std::string& name, const RunContext& run) const {
  if (impossible_ == 0) return;
  if (impossible_ > possible_)
    throw IoError(name, "most of its heights are more than 30 km from sea level, up to " + format_number(worst_) +
                            " m: that is another unit or another coding (\"unit\", \"coding\", or low_m and high_m)");
  run.say(name + ": " + cells_text(impossible_) + " of heights up to " + format_number(worst_) +
          " m, which cannot be: taken as cells without a height");
}

void ImpossibleHeights::take_out(std::span<float> heights) const {
  if (impossible_ == 0) return;
  for (float& z : heights)
    if (std::abs(z) > kMost) z = kNone;
}

void take_out_impossible_heights(Grid<float>& heights, const std::string& name, const RunContext& run) {
  ImpossibleHeights found;
  for (const float z : heights.cells()) found.look(z);
  found.settle(name, run);
  found.take_out(heights.cells());
}

}  // namespace seamount::io
