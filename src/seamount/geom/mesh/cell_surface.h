// Triangles between cell centres as a surface: positions, normals, texture coordinates; and as a closed solid.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/geom/mesh/mesh_domain.h"
#include "seamount/geom/mesh/terrain_fit.h"
#include "seamount/model/grid.h"
#include "seamount/model/mesh.h"

namespace seamount::geom {

/// All cells of a box of the domain, two triangles a square, cut along the diagonal that is closer to level, which
/// follows ridges and valleys.
CellMesh every_cell(const HeightField& heights, const MeshDomain& domain, const CellBox& box);

/// Places of cell centres, x east and y north of the middle of the terrain: rounded to so few bits that a difference of
/// two of them, and its sum with one of them, is exact as a float.
class CellPlaces {
 public:
  explicit CellPlaces(const GridFrame& frame) : CellPlaces(frame, {0, 0}) {}
  /// Cells counted from `first` of the frame's, for a window of it: the same places.
  CellPlaces(const GridFrame& frame, LatticePoint first);
  double x(double column) const;
  double y(double row) const;

 private:
  double width_, height_;  ///< from the first cell counted to the middle, in cells
  double cell_m_, unit_;
};

/// The ground: a vertex for each cell, relative to `offset`, with the normal of the full terrain there. Cells without a
/// height count as level with their neighbours.
MeshPart surface(const CellMesh& mesh, const HeightField& heights, double vertical_scale, const CellPlaces& places,
                 Vec2 offset, const RunContext& run);

/// Walls down from the border and from the rims of holes, and a flat floor of few triangles with the same border, so
/// that the ground encloses a volume: each edge has two triangles, by places of vertices. Walls and floor have vertices
/// of their own. REQUIRES: floor_z below every vertex; `ground` is surface(mesh, ...).
void close_below(MeshPart& ground, const CellMesh& mesh, const MeshDomain& domain, const CellPlaces& places,
                 Vec2 offset, float floor_z, const RunContext& run);

}  // namespace seamount::geom
