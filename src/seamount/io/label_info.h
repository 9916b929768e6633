// What share of a label map each region has: for `seamount info`.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "seamount/model/image.h"
#include "seamount/model/label_map.h"

namespace seamount::io {

/// Cells of each region, by its number, and of none.
struct RegionCounts {
  std::array<int64_t, kRegionCount> cells{};
  int64_t others = 0;
};

/// Of a GeoTIFF that write_labels() made; nothing if the file is any other. Throws IoError if it cannot be read.
std::optional<RegionCounts> count_regions(const std::string& tiff_path);

/// Of a picture in the colours of model/label_map.h, at any subsidence; nothing if more than one pixel in a hundred has
/// another colour.
std::optional<RegionCounts> count_regions(const Image& image);

}  // namespace seamount::io
