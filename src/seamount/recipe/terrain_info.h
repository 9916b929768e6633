// What a terrain file is like at places: its highest peaks, and what lies at one that is asked for.
#pragma once

#include <string>

#include "seamount/io/info.h"
#include "seamount/model/drawn.h"

namespace seamount::recipe {

/// Up to five peaks of a file of heights, the highest first: height, place, and by how much it rises over the highest
/// pass to higher ground (at least a fiftieth of the relief). Nothing for other files, those of over 25 million cells,
/// and without a peak over the sea. Throws IoError. Linear, and n log n in the passes.
io::FileInfo describe_peaks(const std::string& path);

/// A place of a raster, in metres as its frame, or in degrees on WGS 84.
struct Asked {
  Vec2 place;
  bool lonlat = false;
  std::string labels;  ///< a label map that tells the region; empty: none
};

/// Height (linear between cells) and slope of a terrain there, or the value of another raster; longitude and latitude
/// where its system is known; the region of `labels`. Throws InvalidArgument{at} for a place beside the raster or
/// degrees without a system, IoError.
io::FileInfo describe_place(const std::string& path, const Asked& asked);

}  // namespace seamount::recipe
