// Where tiles meet: pairs of neighbouring cells on both sides of a border, by the numbers of their rims
// (geom/water/pieces.h).
#pragma once

#include <algorithm>
#include <cstdint>

#include "seamount/geom/water/pieces.h"
#include "seamount/tiles/layout.h"

namespace seamount::tiles {

struct RimPlace {
  int tile = 0;
  int32_t rim = 0;
};

/// The rim cell of a tile that a cell of the whole is. REQUIRES: it lies on a rim.
inline RimPlace rim_place(const Layout& layout, int column, int row) {
  const int tile = row / layout.size * layout.columns() + column / layout.size;
  const Rect rect = layout.tile(tile);
  return {tile, geom::rim_number(column - rect.column, row - rect.row, rect.width, rect.height)};
}

/// The cell of the whole, column and row.
struct CellPlace {
  int column = 0;
  int row = 0;
};
inline CellPlace cell_place(const Layout& layout, const RimPlace& place) {
  const Rect rect = layout.tile(place.tile);
  const int32_t cell = geom::rim_cell(place.rim, rect.width, rect.height);
  return {rect.column + cell % rect.width, rect.row + cell / rect.width};
}

inline int32_t rim_size(const Layout& layout, int tile) {
  const Rect rect = layout.tile(tile);
  return geom::rim_size(rect.width, rect.height);
}

/// The cells of `rect` from a grid of `window`, which contains them. Both count in the whole.
template <class T>
Grid<T> inner(const Grid<T>& grid, const Rect& window, const Rect& rect) {
  Grid<T> part(grid.frame().window(rect.column - window.column, rect.row - window.row, rect.width, rect.height));
  for (int y = 0; y < rect.height; ++y) {
    const auto row = grid.row(rect.row - window.row + y)
                         .subspan(static_cast<size_t>(rect.column - window.column), static_cast<size_t>(rect.width));
    std::copy(row.begin(), row.end(), part.row(y).begin());
  }
  return part;
}

/// Which sides of a tile are the whole's edge.
inline geom::OpenSides open_sides(const Layout& layout, int tile) {
  const Rect rect = layout.tile(tile);
  return {rect.column == 0, rect.row == 0, rect.column + rect.width == layout.width,
          rect.row + rect.height == layout.height};
}

/// Calls visit(place) for each neighbour, by side or corner, of a rim cell that lies in another tile.
template <class Visit>
void for_each_beyond(const Layout& layout, const RimPlace& place, const Visit& visit) {
  const CellPlace here = cell_place(layout, place);
  const Rect own = layout.tile(place.tile);
  for (size_t k = 0; k < 8; ++k) {
    const int column = here.column + geom::kFlowDx[k], row = here.row + geom::kFlowDy[k];
    if (column < 0 || row < 0 || column >= layout.width || row >= layout.height) continue;
    if (!own.contains({column, row, 1, 1})) visit(rim_place(layout, column, row));
  }
}

/// Calls visit(a, b) once for every pair of neighbours, by side or corner, in different tiles.
template <class Visit>
void for_each_border_pair(const Layout& layout, const Visit& visit) {
  for (int tile = 0; tile < layout.count(); ++tile) {
    for (int32_t rim = 0; rim < rim_size(layout, tile); ++rim) {
      const CellPlace here = cell_place(layout, {tile, rim});
      for (const size_t k : {size_t{0}, size_t{5}, size_t{6}, size_t{7}}) {  // east, south-west, south, south-east
        const int column = here.column + geom::kFlowDx[k], row = here.row + geom::kFlowDy[k];
        if (column < 0 || column >= layout.width || row >= layout.height) continue;
        const int other = row / layout.size * layout.columns() + column / layout.size;
        if (other != tile) visit(RimPlace{tile, rim}, rim_place(layout, column, row));
      }
    }
  }
}

}  // namespace seamount::tiles
