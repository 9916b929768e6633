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
  HeightField heights;  ///< warped to metres (io/raster.h); NaN where unknown
};

/// Whether ground is held out of training: a fifth of all regions, by the hash of the first word of the file's name
/// ("alps" of alps_n46e008), so that tiles of one region, and the same ground in two resolutions, are never on both
/// sides.
bool is_held_out(const std::string& name);

/// The elevation models of land in a folder (GeoTIFF, HGT) that are held out, or the others, in the order of names, and
/// each once more at half of the resolution; those with "bathy", "reef_", "gebco" or "etopo" in their name, which show
/// the sea, are left out. Water becomes unknown: cells that are level (within 5 cm) over 24 cells and more both along
/// their row and their column, and those below -5 m. Throws InvalidArgument{"--dem"} where nothing is found, IoError.
/// Parallel over files.
std::vector<GroundTile> read_ground(const std::string& folder, bool held_out, const RunContext& run);

struct ChosenGround {
  std::vector<GroundTile> learned, held_out;
};

/// The elevation models of a folder in the order of their names, as they are: those whose names begin with one of
/// `tiles`, or all. Those that begin with one of `held_out` are not learned from. Where none of them is chosen, the
/// southern fifth of each tile is held out, and a strip of 32 cells beside it is left out of both. Throws
/// InvalidArgument{"--dem", "--tiles" or "--held-out"} for a folder that cannot be read, a name that no file begins
/// with, and where nothing is left to learn from; IoError for a file that cannot be read. Parallel over files.
ChosenGround read_chosen_ground(const std::string& folder, const std::vector<std::string>& tiles,
                                const std::vector<std::string>& held_out, const RunContext& run);

}  // namespace seamount::train
