// A terrain as a triangulation of few of its cells, in blocks that are refined side by side: where blocks meet, both
// take the vertices of the profile there (edge_fit.h), so that they fit without cracks. Blocks, and so the result,
// depend on the terrain and the options alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/mesh/block_fit.h"
#include "seamount/geom/mesh/edge_fit.h"
#include "seamount/geom/mesh/mesh_domain.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Triangles between cell centres.
struct CellMesh {
  std::vector<LatticePoint> cells;
  std::vector<uint32_t> corners;  ///< three a triangle, counter-clockwise seen from above (north up)
  SurfaceError error;
};

struct TerrainFitOptions {
  int64_t max_triangles = 0;  ///< 0: as many as max_error_m needs
  double max_error_m = 0.0;
};

/// Where a terrain is cut into tiles: neighbours share the cells of a column or a row.
struct TileCuts {
  std::vector<int> columns, rows;  ///< the first and the last of the terrain among them
  int across() const { return static_cast<int>(columns.size()) - 1; }
  int down() const { return static_cast<int>(rows.size()) - 1; }
  CellBox box(int column, int row) const;
};

/// From 0 to `last`, evenly. REQUIRES: 1 <= parts <= last.
std::vector<int> even_cuts(int last, int parts);

class TerrainFit {
 public:
  /// REQUIRES: heights and domain outlive this.
  TerrainFit(const HeightField& heights, const MeshDomain& domain, TileCuts tiles, const TerrainFitOptions& options);

  /// Refines until the error is at most max_error_m, or max_triangles are there. `borders`: the vertices that borders
  /// of tiles have, from a fit of the same tiles, and no others; empty: they are refined like the rest.
  void refine(std::span<const LatticePoint> borders, const RunContext& run);

  /// One tile's part of the result; without triangles where it lies in a hole.
  CellMesh tile(int column, int row, const RunContext& run) const;

  /// Vertices on the borders of tiles.
  std::vector<LatticePoint> border_vertices() const;

 private:
  struct Edge {
    EdgeFit fit;
    std::vector<int> blocks;  ///< one or two
    bool between_tiles = false;
    size_t given = 0;  ///< so many vertices its blocks have
  };

  void add_edges();
  void start(std::span<const LatticePoint> borders, const RunContext& run);
  bool refine_once(const RunContext& run);
  void finish(const RunContext& run);
  std::vector<LatticePoint> extremes() const;
  int64_t count() const;
  double worst() const;
  bool add_worst();

  const HeightField& heights_;
  const MeshDomain& domain_;
  TileCuts tiles_;
  TerrainFitOptions options_;
  int lattice_;                      ///< steps between vertices of the first lattice
  std::vector<int> columns_, rows_;  ///< cuts between blocks
  std::vector<BlockFit> blocks_;
  std::vector<Edge> edges_;
};

}  // namespace seamount::geom
