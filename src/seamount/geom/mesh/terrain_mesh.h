// Terrain as a triangle mesh: vertices are cell centres, relative to the middle of the terrain; simplified, closed to a
// solid, covered by water, or cut into tiles of several levels on demand. io/mesh_file.h writes it.
//
// Simplified meshes are error-driven (terrain_fit.h): of all cells that which is farthest above or below the mesh
// becomes a vertex, until there are enough triangles or none is farther than asked. So the highest and the lowest cell
// are vertices, every triangle faces up, and the mesh covers the rectangle of the cell centres exactly. Cells without a
// height (NaN) leave holes (mesh_domain.h), whose rims are kept cell by cell.
#pragma once

#include <cstdint>
#include <functional>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/mesh.h"

namespace seamount::geom {

struct MeshOptions {
  int64_t max_triangles = 0;    ///< of the ground; 0: as many as max_error_m needs
  double max_error_m = 0.0;     ///< no cell is farther above or below the mesh, if max_triangles allow; 0: none is off.
                                ///< Neither: every cell is a vertex.
  double vertical_scale = 1.0;  ///< > 0
  double base_m = 0.0;          ///< > 0: a closed solid whose flat bottom lies so far below the lowest height, to print
  bool water = true;  ///< a second part at sea level if there is ground below it; not over a solid, which it would open
  const Grid<uint8_t>* hollows = nullptr;  ///< not 0: ground below sea level that is no sea, on the heights' cells
};

/// The terrain's part first; its normals are those of the full terrain, also after simplification. How far it is from
/// the terrain is measured over all cells; run is told, and of holes. Throws InvalidArgument for options out of range,
/// a height that is infinite, or a terrain less than two cells wide or high or without four neighbours that have
/// heights. Simplification: parallel, about n log n, 60 ns a cell and 16 bytes (plus 100 a triangle).
Mesh make_mesh(const HeightField& heights, const MeshOptions& options, const RunContext& run);

struct MeshTiling {
  int across = 1;  ///< tiles along the longer side; as many along the other as make them about square
  int levels = 1;  ///< of detail: each with a quarter of the triangles and twice the error of the one before
};

struct MeshTile {
  int column = 0, row = 0;  ///< from the north-western one
  int level = 0;            ///< 0: the finest
  Mesh mesh;
};

/// Tiles that fit without cracks, also where levels differ: along their borders the vertices of all levels are those of
/// the finest, which bounds how few triangles a coarse one has. max_triangles are those of all tiles of the finest
/// level. Each tile's positions are relative to its middle, mesh.offset; positions plus offset are exactly equal in
/// neighbours. Tiles in holes are left out. They are given to `take` one after the other, the finest level first.
/// Throws as make_mesh(), and for base_m: tiles are open.
void make_mesh_tiles(const HeightField& heights, const MeshOptions& options, const MeshTiling& tiling,
                     const std::function<void(const MeshTile&)>& take, const RunContext& run);

}  // namespace seamount::geom
