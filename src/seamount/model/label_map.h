// The five regions of a coral island (P0 sec. 1.4.1), from the centre outwards, and the raster that carries them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "seamount/base/error.h"
#include "seamount/base/fields.h"
#include "seamount/base/text.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount {

/// A region lies between outline i and outline i + 1; its value is i, so `reef` is i_reef of P0 eq. 1.11.
enum class Region : uint8_t { mountain = 0, beach = 1, lagoon = 2, reef = 3, abyss = 4 };

inline constexpr int kRegionCount = 5;
inline constexpr std::array<Region, kRegionCount> kRegions = {Region::mountain, Region::beach, Region::lagoon,
                                                              Region::reef, Region::abyss};

constexpr std::string_view region_name(Region region) {
  constexpr std::array<std::string_view, kRegionCount> kNames = {"mountain", "beach", "lagoon", "reef", "abyss"};
  return kNames[static_cast<size_t>(region)];
}

using LabelMap = Grid<Region>;

/// Hue in degrees of each Region in pictures that people paint (P0 sec. 1.7), by its number: yellow, green, cyan, blue,
/// red. Saturation is 1; value is the subsidence: V = 1 - 0.8 lambda, never black.
inline constexpr std::array<double, kRegionCount> kRegionHues_deg = {60.0, 120.0, 180.0, 240.0, 0.0};

/// The colour of a region in such a picture. Throws InvalidArgument unless subsidence is in [0, 1].
inline Colour painted_colour(Region region, double subsidence = 0.0) {
  if (!(subsidence >= 0 && subsidence <= 1))
    throw InvalidArgument("subsidence", format_number(subsidence) + " is outside [0, 1]");
  constexpr std::array<std::array<int, 3>, kRegionCount> kPure = {
      {{1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 0}}};
  const auto value = static_cast<uint8_t>(std::lround(255.0 * (1.0 - 0.8 * subsidence)));
  const auto& pure = kPure[static_cast<size_t>(region)];
  const auto channel = [&](size_t c) { return static_cast<uint8_t>(pure[c] * value); };
  return {channel(0), channel(1), channel(2)};
}

}  // namespace seamount

template <>
struct seamount::Choices<seamount::Region> {
  static constexpr std::array<std::string_view, seamount::kRegionCount> names = {"mountain", "beach", "lagoon", "reef",
                                                                                 "abyss"};
};
