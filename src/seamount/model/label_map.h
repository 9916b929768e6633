// The five regions of a coral island (P0 sec. 1.4.1), from the centre outwards, and the raster that carries them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

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

}  // namespace seamount
