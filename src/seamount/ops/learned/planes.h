// What a network sees of a map: planes, made a band of rows at a time so that a large map is never held sixteen times.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "seamount/base/rng.h"

namespace seamount::learned {

/// Input planes of a map. fill(begin, end, values) writes rows [begin, end) of all planes, channels last:
/// values[((y - begin) width + x) planes + plane]. Called for rows of the map only, by several threads at once, and
/// more than once for a row; the same row must get the same numbers each time.
struct Planes {
  int width = 0, height = 0, count = 0;
  std::function<void(int begin, int end, std::span<float> values)> fill;
  bool kept = false;  ///< they lie in memory: fill copies
};

/// Noise of a cell: even, of mean 0 and deviation 1.
inline float cell_noise(Seed seed, int x, int y) {
  const uint64_t cell = static_cast<uint64_t>(y) << 32 | static_cast<uint32_t>(x);
  const uint64_t bits = mix_bits(seed.value ^ (cell * 0xd1342543de82ef95ULL)) >> 40;
  return 3.4641F * (static_cast<float>(bits) * 0x1p-24F - 0.5F);
}

}  // namespace seamount::learned
