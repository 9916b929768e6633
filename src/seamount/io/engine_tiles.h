// What engines want of a world in tiles: which sizes, whether neighbours share their border, how files are named, and
// where each tile goes.
//
// Unreal's world composition loads landscapes that share their border samples, each of a size that landscapes have; its
// world partition imports files NAME_x0_y0 as one landscape and puts them side by side, so they share nothing, and any
// size will do. Both count x to the east and y to the south. Unity's terrains share their borders; its Terrain Toolbox
// reads NAME_0_0, x to the east and z to the north. Godot's Terrain3D keeps regions of 2^n samples side by side.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "seamount/io/tiles.h"

namespace seamount::io {

/// Do tiles of an engine share their borders unless something else is asked for?
bool engine_shares_borders(Engine engine);

/// Samples a side of an engine's tiles unless something else is asked for.
int engine_tile_size(Engine engine);

/// Sizes of tiles that an engine reads; empty: any.
std::vector<int> engine_tile_sizes(Engine engine, bool share_border);

/// What is wrong with tiles for an engine that does not hang on the terrain: throws InvalidArgument with the field's
/// name: {"tile_size"}, {"share_border"} for what the engine cannot put together, {"last_tiles"} for smaller ones,
/// {"engine"} for Blender, which has no tiles.
void check_engine_tiles(const TileOptions& options);

/// Would Unreal take digits of a file's name, which follow x, y, u or v, for a tile's number?
bool confuses_unreal(const std::string& path);

/// "_x1_y0", of Unity "_1_0" with the second number counted from the south.
std::string tile_suffix(std::optional<Engine> engine, int x, int y, int rows);

/// Where a tile of so many goes, in the engine's own words and units: {"Location X", "..."} and so on; nothing where
/// the engine needs none. The terrain's middle is Unreal's and, to whole regions, Godot's origin; the south-western
/// tile's corner is Unity's.
std::vector<ImportNumber> tile_place(const Tile& tile, int columns, int rows, const GridFrame& whole,
                                     const TileOptions& options, const HeightRange& range);

}  // namespace seamount::io
