#include "seamount/ops/hydrology/tally.h"

#include <cstdlib>

namespace seamount::hydrology {

Distribution Tally::distribution(const std::vector<Tally>& parts) {
  const Tally& first = parts.front();
  std::vector<int64_t> counts(first.counts_.size(), 0);
  Moments moments;
  for (const Tally& part : parts) {
    for (size_t i = 0; i < counts.size(); ++i) counts[i] += part.counts_[i];
    moments.join(part.moments_.moments());
  }
  std::vector<Distribution::Bin> bins;
  for (size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) bins.push_back(first.bin(i, counts[i]));
  if (!bins.empty()) {
    bins.front().low = moments.low;
    bins.back().high = moments.high;
  }
  return {std::move(bins), moments};
}

Distribution::Bin Tally::bin(size_t place, int64_t count) const {
  const int from_middle = static_cast<int>(place) - kSide, steps = std::abs(from_middle);
  const auto edge = [](int step) {
    return static_cast<double>(std::bit_cast<float>(static_cast<uint32_t>(kFirst + step) << (23 - kMantissaBits)));
  };
  const auto origin = static_cast<double>(origin_);
  if (steps == 0) return {origin, origin, count};
  if (from_middle < 0) return {origin - edge(steps), origin - edge(steps - 1), count};
  const double low = edge(steps - 1), high = edge(steps);
  return {origin + low, origin + (whole_ && high - low <= 1.0 ? low : high), count};
}

}  // namespace seamount::hydrology
