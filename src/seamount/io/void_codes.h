// Cells that hold a code for "nothing is known here" which the file does not declare, and heights that cannot be.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::io {

/// Cells of the usual codes (-9999, -32768, 32767, 3.4e38 and what is like it) become NaN, and it is said how many;
/// -9999 and the like only where no other value comes near them, so that a deep sea stays. `stored`: values as the file
/// holds them, before any scale or unit. Numbers above 0 are codes in rasters of heights only: of anything else 32767
/// may be a count. Linear.
void take_out_void_codes(Grid<float>& stored, const std::string& name, bool heights, const RunContext& run);

/// The same for a raster that is looked at and cleaned part by part.
class VoidCodes {
 public:
  explicit VoidCodes(bool heights) : heights_(heights) {}

  void look(std::span<const float> stored);
  /// Once all is looked at: which of them are codes.
  void settle();
  /// Can this value be a code, whatever else there is?
  static bool candidate(float z);
  /// visit(value, cells) for candidates that were no codes.
  template <class Visit>
  void each_kept(const Visit& visit) const {
    for (const Code& code : codes_)
      if (code.kept > 0) visit(code.value, code.kept);
  }
  /// Cells of codes.
  int64_t count() const;
  void take_out(std::span<float> stored) const;
  void say(const std::string& name, const RunContext& run) const;

 private:
  struct Code {
    float value;
    int64_t cells = 0;
    int64_t near = 0;  ///< other values that come near it
    int64_t kept = 0;  ///< cells of what is no code
  };
  bool heights_;
  std::array<Code, 9> codes_{{{-9999}, {-32768}, {-32767}, {32767}, {-99999}, {9999}, {99999}, {-999999}, {999999}}};
  int64_t huge_ = 0;
  float first_huge_ = 0;
};

/// Heights more than 30 km from sea level become NaN, and it is said how many. Throws IoError where most are such: then
/// the unit is not what it was taken for. Linear.
void take_out_impossible_heights(Grid<float>& heights, const std::string& name, const RunContext& run);

/// The same part by part.
class ImpossibleHeights {
 public:
  /// A height of `cells` cells; unknown ones (NaN) do not count.
  void look(float height, int64_t cells = 1);
  /// Once all is looked at. Throws IoError where most are impossible; says how many are.
  void settle(const std::string& name, const RunContext& run) const;
  int64_t count() const { return impossible_; }
  /// Between the lowest and the highest that is possible; 0 without any.
  double relief() const { return possible_ > 0 ? static_cast<double>(high_) - static_cast<double>(low_) : 0.0; }
  void take_out(std::span<float> heights) const;

 private:
  int64_t impossible_ = 0, possible_ = 0;
  float worst_ = 0, low_ = 0, high_ = 0;
};

}  // namespace seamount::io
