// Windows of rasters as values of recipes.
#pragma once

#include "seamount/recipe/value.h"
#include "seamount/tiles/layout.h"

namespace seamount::tiles {

/// Is it a kind of raster that is cut into tiles: terrain, field, labels?
bool is_raster(const recipe::Kind& kind);

/// Bytes of a cell of such a kind.
size_t cell_bytes(const recipe::Kind& kind);

/// Cells of a value as a window of it; the value itself if it is all of it. `rect` counts from the value's own first
/// cell. REQUIRES: a raster that contains them.
recipe::Value window_of(const recipe::Value& value, const Rect& rect);

/// A raster of a kind with its cells not yet set, and where they lie.
struct Blank {
  recipe::Value value;
  void* cells = nullptr;
};
Blank blank_raster(const recipe::Kind& kind, const GridFrame& frame);

/// The cells of a raster, row by row.
const void* cells_of(const recipe::Value& value);

/// Has it a cell without a value?
bool has_unknown(const recipe::Value& value);

}  // namespace seamount::tiles
