// Elevation models to learn from, and those that are held out to measure by.
#pragma once

#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::train {

struct DemTile {
  std::string name;     ///< the file's, without extension
  HeightField terrain;  ///< square cells in metres (io/raster.h); NaN where nothing is known
};

struct DemTiles {
  std::vector<DemTile> learned, held_out;
};

/// GeoTIFF and HGT files of a folder, in the order of their names: those whose names begin with one of `tiles`, or all.
/// Those that begin with one of `held_out` are not learned from. Where none of them is chosen, the southern fifth of
/// each tile is held out, and a strip of 32 cells beside it is left out of both. Throws InvalidArgument{"--dem",
/// "--tiles" or
/// "--held-out"} for a folder that cannot be read, a name that no file begins with, and where nothing is left to learn
/// from; IoError for a file that cannot be read.
DemTiles read_dem_tiles(const std::string& folder, const std::vector<std::string>& tiles,
                        const std::vector<std::string>& held_out, const RunContext& run);

}  // namespace seamount::train
