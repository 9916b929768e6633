// A histogram of values whose range is not known beforehand: bins are as wide as a 256th of their distance from an
// origin.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/ops/hydrology/distribution.h"

namespace seamount::hydrology {

/// A bin holds the values whose distances from the origin agree in sign, exponent and the first eight bits of a float's
/// mantissa. Distances below 2^-34 count as none; those above 2^40 share a bin.
class Tally {
 public:
  /// `whole`: distances are whole numbers, so a bin no wider than 1 holds one value.
  Tally(float origin, bool whole) : origin_(origin), whole_(whole), counts_(static_cast<size_t>(2 * kSide + 1), 0) {}

  void add(float value) {
    const float distance = value - origin_;
    const auto bits = std::bit_cast<uint32_t>(distance);
    const auto cut = static_cast<int>((bits & 0x7fffffffU) >> (23 - kMantissaBits));
    const int bin = std::clamp(cut - kFirst + 1, 0, kSide);
    ++counts_[static_cast<size_t>(distance < 0.0F ? kSide - bin : kSide + bin)];
    moments_.add(static_cast<double>(value));
  }

  /// Of the values of all parts. REQUIRES: one or more, of one origin.
  static Distribution distribution(const std::vector<Tally>& parts);

 private:
  static constexpr int kMantissaBits = 8, kFirstExponent = -34, kLastExponent = 40;
  static constexpr int kSide = (kLastExponent - kFirstExponent) << kMantissaBits;  ///< bins to either side of 0
  static constexpr int kFirst = (kFirstExponent + 127) << kMantissaBits;           ///< a float's bits, cut

  Distribution::Bin bin(size_t place, int64_t count) const;

  float origin_;
  bool whole_;
  std::vector<uint32_t> counts_;  ///< from the lowest values on
  RunningMoments moments_;
};

/// Those of `count` values that `counts` allows, in parallel. Parts depend on the count alone, so that any number of
/// threads gives the same bits.
template <class Counts, class Value>
Distribution gather(const Tally& empty, int64_t count, const Counts& counts, const Value& value,
                    const RunContext& run) {
  constexpr int64_t kShortest = int64_t{1} << 17, kMostParts = 32;
  const int64_t grain = std::max(kShortest, (count + kMostParts - 1) / kMostParts);
  std::vector<Tally> parts(static_cast<size_t>(std::max<int64_t>(1, (count + grain - 1) / grain)), empty);
  parallel_blocks(run, count, grain, [&](int64_t begin, int64_t end) {
    Tally& part = parts[static_cast<size_t>(begin / grain)];
    for (int64_t i = begin; i < end; ++i)
      if (counts(i)) part.add(value(i));
  });
  return Tally::distribution(parts);
}

}  // namespace seamount::hydrology
