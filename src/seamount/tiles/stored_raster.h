// A raster on disk, tile by tile: a file for each tile, written whole or not at all, so that what a killed run has made
// is of use to the next one. Rows are packed and checksummed in bands: a part of a tile is read without the rest.
#pragma once

#include <memory>
#include <string>

#include "seamount/recipe/value.h"
#include "seamount/tiles/folder_use.h"
#include "seamount/tiles/layout.h"

namespace seamount::tiles {

class StoredRaster {
 public:
  /// A raster of a kind with the frame `whole` in `folder`, of which there may be some tiles already, or none. The
  /// folder's name says of what: a folder belongs to one raster and one size of tiles. It is used as long as this
  /// lives: another run that shares it does not remove it.
  StoredRaster(std::string folder, const recipe::Kind& kind, GridFrame whole, int tile_size);

  const GridFrame& frame() const { return whole_; }
  const recipe::Kind& kind() const { return *kind_; }
  const Layout& layout() const { return layout_; }

  /// Is the tile there, as far as its file's beginning, length and list of bands say?
  bool has(int tile) const;
  bool complete() const;

  /// May be called for different tiles, and for the same, by many threads and processes. Throws WriteError.
  void write(int tile, const recipe::Value& cells) const;

  /// The cells of `rect`, a window of the whole. Throws IoError for a tile that is missing or damaged; the latter is
  /// removed, so that the next run makes it anew.
  recipe::Value read(const Rect& rect) const;

  /// The same cells, row by row, to `out`. Memory: a band of a tile.
  void read_to(const Rect& rect, void* out) const;

  /// Uses the tiles no longer; removes them, unless another run uses them.
  void let_go() const noexcept { use_->end(); }
  void remove() const noexcept { use_->end_and_remove(); }

 private:
  std::string path_of(int tile) const;
  void read_part(int tile, const Rect& rect, std::byte* out, size_t row_bytes) const;

  std::string folder_;
  const recipe::Kind* kind_;
  GridFrame whole_;
  Layout layout_;
  std::unique_ptr<FolderUse> use_;
};

}  // namespace seamount::tiles
