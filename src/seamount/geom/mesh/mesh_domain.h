// Which part of a terrain a mesh covers: what lies between cell centres that have heights. Four known neighbours make a
// square, three a triangle; void cells (NaN) leave holes. Where two such pieces would touch in a single point only, the
// smaller one is left out, so that every mesh over the domain is a surface: a point of its border has two neighbours on
// it.
//
// A hole's rim runs over unit steps and diagonals between cells that are `rim()`. These are edges of EVERY Delaunay
// triangulation that has all of them and none of the void cells: no other cell lies within the circle over such a step.
// So each of its triangles is wholly inside or wholly outside.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/polygon/lattice_points.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// A square between four cell centres, (x, y) the north-western one: what of it the domain holds.
enum class MeshSquare : uint8_t { none, whole, without_nw, without_ne, without_sw, without_se };

class MeshDomain {
 public:
  /// REQUIRES: at least 2 x 2 cells. Linear, serial where there are voids.
  MeshDomain(const HeightField& heights, const RunContext& run);

  bool is_whole() const { return squares_.empty(); }  ///< no voids
  int width() const { return width_; }
  int height() const { return height_; }

  /// `none` outside.
  MeshSquare square(int x, int y) const {
    if (x < 0 || y < 0 || x >= width_ - 1 || y >= height_ - 1) return MeshSquare::none;
    return is_whole() ? MeshSquare::whole : squares_[at(x, y)];
  }
  /// Is the cell's centre in the domain, its border included?
  bool holds(LatticePoint cell) const { return is_whole() || sectors(cell.x, cell.y) != 0; }
  /// Does it touch a square of the terrain that is not whole?
  bool is_rim(LatticePoint cell) const;
  /// Is the step between two neighbours in a row or a column in the domain?
  bool holds_step(LatticePoint a, LatticePoint b) const;
  /// Is a triangle without rim cells inside, of a triangulation as above, in the domain?
  bool holds_triangle(LatticePoint a, LatticePoint b, LatticePoint c) const;
  /// Is the cell in what the domain holds of the square (x, y), of which it is a corner?
  bool square_holds(int x, int y, LatticePoint cell) const;

  int64_t triangles() const { return triangles_; }      ///< with every cell a vertex
  int64_t known_cells() const { return known_; }        ///< those with heights
  int64_t left_out_cells() const { return left_out_; }  ///< with a height, and not in the domain

 private:
  size_t at(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width_ - 1) + static_cast<size_t>(x);
  }
  unsigned sectors(int x, int y) const;
  bool part_where_pinched(int x, int y);
  void part_all();

  int width_, height_;
  std::vector<MeshSquare> squares_;  ///< empty: all whole
  int64_t triangles_ = 0, known_ = 0, left_out_ = 0;
};

}  // namespace seamount::geom
