// Repeatable randomness without shared state: a number depends only on (seed, purpose, index, draw), so that parallel
// code draws the same numbers on any number of threads. Hash: the SplitMix64 finaliser (Steele, Lea and Flood 2014).
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

namespace seamount {

/// SplitMix64 finaliser: a bijection of 64 bits that passes the usual avalanche tests.
constexpr uint64_t mix_bits(uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// The user's seed, or one derived from it for a purpose ("strokes") and an index (the third stroke).
struct Seed {
  uint64_t value = 0;

  constexpr Seed derive(std::string_view purpose, uint64_t index = 0) const {
    uint64_t h = 0xcbf29ce484222325ULL;
    for (const char c : purpose) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return {mix_bits(mix_bits(value + 0x9e3779b97f4a7c15ULL) ^ mix_bits(h) ^ (index * 0xd1342543de82ef95ULL))};
  }

  bool operator==(const Seed&) const = default;
};

/// A stream of numbers for one purpose and index: Rng rng(seed.derive("strokes", 3)).
class Rng {
 public:
  explicit constexpr Rng(Seed seed) : state_(seed.value) {}

  constexpr uint64_t bits() { return mix_bits(state_ += 0x9e3779b97f4a7c15ULL); }

  /// Uniform in [0, 1), 53 bits.
  constexpr double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  /// Uniform in [low, high).
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Uniform integer in [low, high], both included. Bias below 2^-32 for ranges below 2^32.
  constexpr int integer(int low, int high) {
    const uint64_t range = static_cast<uint64_t>(static_cast<int64_t>(high) - low) + 1;
    return static_cast<int>(low + static_cast<int64_t>(((bits() >> 32) * range) >> 32));
  }

  constexpr bool chance(double probability) { return uniform() < probability; }

  /// Normal with mean 0 and deviation 1 (Box-Muller, one of the pair).
  double normal() {
    const double r = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return r * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  uint64_t state_;
};

}  // namespace seamount
