// Whether a raster holds heights, and not a mask, a slope or another field.
#pragma once

#include <string>

namespace seamount::io {

/// Of our own files as they say; of others those of one band of more than 8 bits that say where they lie, and formats
/// of heights (.asc, .hgt). False for files that are no rasters; throws IoError for one that cannot be read.
bool holds_heights(const std::string& path);

}  // namespace seamount::io
