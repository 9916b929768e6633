// Neighbouring rasters as one: the sheets and tiles in which elevation data come.
#pragma once

#include <string>
#include <vector>

#include "seamount/io/raster.h"

namespace seamount::io {

/// The heights of all files on the cells of the first, which are warped to metres, where they must be, once they are
/// joined: files on one lattice (tiles of one set, also across the 180th meridian) come together cell by cell, without
/// any seam; others are read between their cells (bilinear). Where several have a height the first of them counts;
/// NaN where none has. options: as read_heights(); a range holds for all. Throws IoError as read_heights(), and for a
/// file that lies nowhere or together more than max_cells; InvalidArgument{"files"} for none.
HeightField read_joined_heights(const std::vector<std::string>& paths, const ReadOptions& options = {});

}  // namespace seamount::io
