// Real ground to learn from: elevation models as square cells in metres, in training or held out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::train {

struct GroundTile {
  std::string name;     ///< of the file, without its ending
  HeightField heights;  ///< NaN where unknown, and where water lies level
};

/// Whether ground is held out of training: a fifth of all regions, by the hash of the first word of the file's name
/// ("alps" of alps_n46e008), so that tiles of one region, and the same ground in two resolutions, are never on both
/// sides.
bool is_held_out(const std::string& name);

/// Every GeoTIFF of land in a folder, in the order of names, warped to metres (io/raster.h) and once more at half of
/// the resolution; those with "bathy", "reef_", "gebco" or "etopo" in their name, which show the sea, are left out.
/// Water becomes unknown: cells that are level (within 5 cm)
/// over 24 cells and more both along their row and their column, and those below -5 m. `held_out` says which
/// side. Throws InvalidArgument{"--dem"} where nothing is found, IoError. Parallel over files.
std::vector<GroundTile> read_ground(const std::string& folder, bool held_out, const RunContext& run);

}  // namespace seamount::train
