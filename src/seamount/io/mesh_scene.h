// Meshes in tiles as one: a list of where each goes, and a glTF scene of all, which refers to their GLB files and holds
// nothing itself.
#pragma once

#include <string>
#include <vector>

#include "seamount/io/provenance.h"
#include "seamount/model/grid.h"

namespace seamount::io {

/// A mesh that is a tile of a terrain, or a level of detail of one.
struct TileMesh {
  int x = 0;  ///< from the west
  int y = 0;  ///< from the north
  int level = 0;
  std::string path;
  int column = 0, row = 0, width = 0, height = 0;  ///< the terrain's samples that it covers
  double east_m = 0.0, north_m = 0.0;              ///< its origin, from the terrain's middle
  double low_m = 0.0, high_m = 0.0;                ///< of its positions
  double largest_error_m = 0.0;                    ///< from the terrain, before the vertical scale
  size_t triangles = 0;
};

struct MeshTileSet {
  GridFrame frame;  ///< of the terrain
  int tile_size = 0, columns = 0, rows = 0, levels = 1;
  double vertical_scale = 1.0;
  std::vector<TileMesh> tiles;  ///< by rows from the north, the levels of a tile after each other
  Provenance provenance;
};

/// "name_tiles.json" and "name.gltf" of "name.glb".
std::string mesh_list(const std::string& path);
std::string mesh_scene(const std::string& path);

/// Writes mesh_list(path): the whole, and of each tile its file, place, extent, triangles and error. Throws WriteError.
void write_mesh_list(const MeshTileSet& set, const std::string& path);

/// Writes mesh_scene(path): a node for each tile, translated to its place, with the finest level; coarser ones as the
/// extension MSFT_lod says, for programs that know it. Its buffers are the GLB files themselves, which must stay beside
/// it. REQUIRES: write_mesh() has written them. Throws WriteError, IoError for a file that has gone.
void write_mesh_scene(const MeshTileSet& set, const std::string& path);

}  // namespace seamount::io
