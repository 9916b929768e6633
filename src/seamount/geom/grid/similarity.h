// Similarity transforms: grids laid on another frame, turned, scaled and moved, and where in such a grid the cells of a
// row of the frame lie.
#pragma once

#include <vector>

#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Carries `origin` to `place`, turned counter-clockwise and scaled about it.
struct Similarity {
  Vec2 place;
  double cosine = 1.0;
  double sine = 0.0;
  double scale = 1.0;
  Vec2 origin = {};

  /// The point that comes to lie at p.
  Vec2 source(Vec2 p) const {
    const Vec2 d = (1.0 / scale) * (p - place);
    return {origin.x + (cosine * d.x + sine * d.y), origin.y + (-sine * d.x + cosine * d.y)};
  }
};

/// Where the cells of one row lie in a placed grid, as fractional columns and rows of it. Cells [first, last) lie on
/// the grid (up to its outer edges); only their places are filled in unless all are asked for.
class PlacedRow {
 public:
  explicit PlacedRow(int width) : columns(static_cast<size_t>(width)), rows(columns.size()) {}

  /// Row `y` of `frame` on a grid with the frame `own`. With `all`, columns and rows of every cell are filled in.
  void locate(const Similarity& placement, const GridFrame& own, const GridFrame& frame, int y, bool all = false);

  std::vector<float> columns, rows;
  int first = 0, last = 0;
};

}  // namespace seamount::geom
