// A rectangle of a terrain as a Delaunay triangulation of few of its cells: the cell that is farthest above or below
// its triangle becomes a vertex, and again (Garland and Heckbert 1995, "Fast polygonal approximation of terrains and
// height fields", algorithm III: a heap of triangles by their worst cell, only what changed is measured again).
//
// The cells of its border are left to others, who give those that are vertices: see edge_fit.h.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "seamount/geom/mesh/mesh_domain.h"
#include "seamount/geom/tin/delaunay_builder.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Cells from one corner to another, both included.
struct CellBox {
  LatticePoint first, last;
  bool operator==(const CellBox&) const = default;
};

/// How far a surface is above or below the cells that it covers.
struct SurfaceError {
  double largest_m = 0.0;
  double square_sum = 0.0;
  int64_t cells = 0;
  void add(const SurfaceError& other);
};

class BlockFit {
 public:
  static constexpr int kBits = 14;
  static constexpr int kMostSteps = (1 << kBits) - 1;  ///< from one side of a block to the other

  /// REQUIRES: sides of 1 to kMostSteps steps; heights and domain outlive this.
  BlockFit(const HeightField& heights, const MeshDomain& domain, CellBox box);

  /// The first triangulation. REQUIRES: cells of the domain within the box, among them all of its corners and of the
  /// rims of holes that the domain holds there.
  void start(std::vector<LatticePoint> cells);

  /// Adds vertices on the border.
  void insert(std::span<const LatticePoint> cells);

  /// Adds the worst cells as vertices while there is one worse than error_m, and no more than `most` triangles.
  void refine(double error_m, int64_t most);

  double error_m() const;                            ///< of the worst cell that is not on the border
  int64_t triangle_count() const { return count_; }  ///< those in the domain
  const CellBox& box() const { return box_; }

  /// Cells of a triangle, counter-clockwise seen from above (so clockwise in columns and rows), for each in the domain.
  template <class Visit>
  void for_each_triangle(Visit&& visit) const {
    for (int32_t t = 0; t < static_cast<int32_t>(faces_.size()); ++t) {
      if (!faces_[static_cast<size_t>(t)].inside) continue;
      const Triangle abc = builder_.corners(t);
      visit(cell(abc[0]), cell(abc[2]), cell(abc[1]));
    }
  }

  /// Of all cells that it covers and that lie in `counted`, each once: those for which an earlier block stands, that
  /// shares them, are not counted.
  SurfaceError measure(const CellBox& counted) const;

 private:
  struct Face {
    double error = 0.0;
    int16_t x = 0, y = 0;  ///< the worst cell, in the box
    uint32_t stamp = 0;
    bool inside = false;
  };
  struct Waiting {
    double error;
    int32_t face;
    uint32_t stamp;
    bool operator<(const Waiting& other) const {
      return error != other.error ? error < other.error : face > other.face;
    }
  };

  LatticePoint cell(int32_t point) const;
  template <class Visit>
  void for_each_cell(LatticePoint a, LatticePoint b, LatticePoint c, const CellBox& within, Visit&& visit) const;
  void changed(std::span<const int32_t> faces);
  void measure_face(int32_t t);
  void drop_stale();

  const HeightField& heights_;
  const MeshDomain& domain_;
  CellBox box_;
  DelaunayBuilder<kBits> builder_{{}};
  std::vector<Face> faces_;
  std::vector<Waiting> heap_;  ///< of those with an error worth to mend, and of some that are gone
  int64_t count_ = 0;
};

}  // namespace seamount::geom
