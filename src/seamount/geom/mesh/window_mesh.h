// One tile of a terrain as meshes, from a window of it: for worlds that are not in memory as a whole, and for engines
// that load tile by tile.
//
// Whatever neighbours share hangs on what both see: a border's vertices on the profile along it (edge_fit.h), their
// normals on these and on the cells around. So tiles that are made apart fit exactly, position by position and normal
// by normal, and all levels of detail have the finest one's borders: tiles of any levels fit without cracks.
//
// A normal is that of the plane through the cells that the vertex stands for, half way to its neighbours and at most
// eight away. Vertices of a simplified mesh are tops and hollows of small bumps: normals of single cells there are
// level, those of a border's vertices are not, and one would see the borders.
#pragma once

#include <utility>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/mesh/terrain_fit.h"
#include "seamount/model/grid.h"
#include "seamount/model/mesh.h"

namespace seamount::geom {

/// A part of a terrain.
struct TerrainWindow {
  const HeightField& heights;
  GridFrame whole;     ///< of the terrain
  LatticePoint first;  ///< the window's first cell in it
};

struct WindowMeshOptions {
  double max_error_m = 0.0;  ///< of the finest level: no cell is farther above or below it; 0: every cell is a vertex
  int levels = 1;            ///< each has twice the error of the one before
  double vertical_scale = 1.0;  ///< > 0
};

/// The error that a level may have. If the finest has none, the next begins at a tenth of a cell.
double level_error_m(const WindowMeshOptions& options, double cell_m, int level);

/// The cells of the terrain that a window must have for the tile `box`: some more on every side that it has.
CellBox cells_around(const CellBox& box, const GridFrame& whole, const WindowMeshOptions& options);

/// The meshes of the tile `box`, cells of the whole terrain, the finest first. Positions are relative to the tile's
/// middle, mesh.offset, which is relative to the terrain's; together they are exactly those of make_mesh(), and equal
/// in neighbours. Texture coordinates are those of the whole terrain. REQUIRES: the window has cells_around(box), the
/// box at least 2 x 2 cells. Throws InvalidArgument for options out of range and for a cell without a finite height.
/// About 100 ns a cell and level; serial for tiles of up to 512 cells.
std::vector<Mesh> window_meshes(const TerrainWindow& window, const CellBox& box, const WindowMeshOptions& options,
                                const RunContext& run);

/// The lowest and the highest z of a part's positions.
std::pair<float, float> heights_of(const MeshPart& part);

}  // namespace seamount::geom
