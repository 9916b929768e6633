// How a raster is cut into tiles: squares of one size from its north-western corner, the last ones narrower.
#pragma once

#include <algorithm>
#include <string>

#include "seamount/model/grid.h"
#include "seamount/model/reach.h"

namespace seamount::tiles {

/// Cells of a raster: `width` x `height` of them from (column, row) on.
struct Rect {
  int column = 0;
  int row = 0;
  int width = 0;
  int height = 0;

  int64_t cells() const { return int64_t{width} * height; }
  bool empty() const { return width <= 0 || height <= 0; }
  bool contains(const Rect& other) const {
    return other.column >= column && other.row >= row && other.column + other.width <= column + width &&
           other.row + other.height <= row + height;
  }
  bool operator==(const Rect&) const = default;
};

/// The smallest rectangle with both; one that is empty does not count.
Rect united(const Rect& a, const Rect& b);

/// What both cover; empty if they are apart.
Rect common(const Rect& a, const Rect& b);

/// The cells that an operator must be run on, so that those of `rect` are as in a run of the whole `frame`: on every
/// side as many more as it looks far, from a multiple of its step on, as far as the raster goes.
Rect with_reach(const Rect& rect, const Reach& reach, const GridFrame& frame);

/// Tiles of `size` x `size` cells, numbered row by row.
struct Layout {
  int width = 0;
  int height = 0;
  int size = 0;

  Layout(const GridFrame& frame, int tile_size) : width(frame.width), height(frame.height), size(tile_size) {}

  int columns() const { return (width + size - 1) / size; }
  int rows() const { return (height + size - 1) / size; }
  int count() const { return columns() * rows(); }
  Rect tile(int index) const {
    const int column = index % columns() * size, row = index / columns() * size;
    return {column, row, std::min(size, width - column), std::min(size, height - row)};
  }
  /// "tile 3 of row 5 (columns 1024 to 1535, rows 2048 to 2559)", both counted from 1 but for the cells.
  std::string name(int index) const;
};

}  // namespace seamount::tiles
