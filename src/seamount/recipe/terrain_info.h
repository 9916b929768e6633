// What a terrain file is like at places: where it lies, its highest peaks, and what lies at one that is asked for.
#pragma once

#include <string>

#include "seamount/io/info.h"
#include "seamount/model/drawn.h"

namespace seamount::recipe {

/// What a file of heights covers, in metres of its system and in degrees where it has one; and up to five peaks, the
/// highest first: height, place, and by how much it rises over the highest pass to higher ground (at least a fiftieth
/// of the relief); none without a peak over the sea. Nothing for other files and those of over 25 million cells. Throws
/// IoError. Linear, and n log n in the passes.
io::FileInfo describe_terrain(const std::string& path);

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
