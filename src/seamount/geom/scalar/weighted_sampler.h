// Weighted random sampling from a changing set: items are drawn with probability exactly proportional to their weights,
// in expected constant time whatever is added and removed: composition and rejection over power-of-two classes of
// weight (Devroye 1986, sec. III; Matias, Vitter and Ni 1993). Weights are integers, so nothing drifts and nothing is
// rounded.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "seamount/base/rng.h"

namespace seamount::geom {

class WeightedSampler {
 public:
  /// The largest weight.
  static constexpr uint32_t kMost = uint32_t{1} << 30;

  /// Where an item lies. Adding keeps places, remove(place) may move the last item of its class to that place.
  struct Place {
    uint32_t level = 0;
    uint32_t slot = 0;
  };

  bool empty() const { return total_ == 0; }

  /// REQUIRES: weight in [1, kMost].
  void add(uint32_t item, uint32_t weight) {
    const auto level = static_cast<uint32_t>(std::bit_width(weight - 1));
    levels_[level].push_back({item, weight});
    total_ += uint64_t{1} << level;
  }

  /// A dart at a row of strips, as wide as the class's largest weight allows, of which each item fills its weight;
  /// thrown again where it misses, in less than half of the cases. REQUIRES: not empty.
  Place draw(Rng& rng) const {
    while (true) {
      __extension__ using Wide = unsigned __int128;
      auto dart = static_cast<uint64_t>((static_cast<Wide>(rng.bits()) * total_) >> 64);
      uint32_t level = kLevels - 1;
      for (uint64_t width = size(level); dart >= width; width = size(--level)) dart -= width;
      const auto slot = static_cast<uint32_t>(dart >> level);
      if ((dart & ((uint64_t{1} << level) - 1)) < levels_[level][slot].weight) return {level, slot};
    }
  }

  uint32_t item(Place place) const { return levels_[place.level][place.slot].item; }

  void remove(Place place) {
    std::vector<Entry>& entries = levels_[place.level];
    entries[place.slot] = entries.back();
    entries.pop_back();
    total_ -= uint64_t{1} << place.level;
  }

 private:
  static constexpr uint32_t kLevels = 31;

  struct Entry {
    uint32_t item, weight;
  };

  uint64_t size(uint32_t level) const { return static_cast<uint64_t>(levels_[level].size()) << level; }

  std::array<std::vector<Entry>, kLevels> levels_;  ///< level k: weights in (2^(k-1), 2^k]
  uint64_t total_ = 0;                              ///< of size(level)
};

}  // namespace seamount::geom
