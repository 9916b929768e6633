// Flats that lie over the borders of tiles: found tile by tile, drained each as a whole.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"
#include "seamount/tiles/borders.h"

namespace seamount::tiles {

/// The part in a tile of a flat that reaches its rim.
struct FlatPart {
  Rect around;  ///< of the whole
  CellPlace first;
};

/// What a tile says of them.
struct TileFlats {
  std::vector<FlatPart> parts;
  std::vector<int32_t> part_of_rim;  ///< by rim number: an index in `parts`; -1: no flat
  std::vector<float> height_of_rim;
};

/// `surface`: filled heights of the tile and a ring of one cell around it, as far as the whole goes.
TileFlats find_flats(const Layout& layout, const GridFrame& frame, int tile, const HeightField& surface, float sea_m);

/// Directions of cells of flats in a tile.
struct FlatCodes {
  std::vector<int32_t> cells;
  std::vector<uint8_t> codes;
};

class BorderFlats {
 public:
  /// `tiles`: what each of them says.
  BorderFlats(const Layout& layout, const GridFrame& frame, float sea_m, std::vector<TileFlats> tiles);

  /// Drains those that are a tile's: each flat belongs to the first tile that it lies in. By tile in which cells lie;
  /// 5 bytes a cell. `read` gives filled heights;
  /// `check` may throw for a rectangle that is too large.
  std::map<int, FlatCodes> drain(int tile, const std::function<HeightField(const Rect&)>& read,
                                 const std::function<void(const GridFrame&)>& check, const RunContext& run) const;

  /// The tiles whose flats lie in a tile too.
  const std::set<int>& owners(int tile) const { return owners_[static_cast<size_t>(tile)]; }

 private:
  struct Flat {
    Rect around;
    CellPlace first;
  };
  Rect window_of(const Flat& flat) const;
  /// `surface`: of its window.
  void drain_one(const Flat& flat, const HeightField& surface, const RunContext& run,
                 std::map<int, FlatCodes>& codes) const;

  const Layout& layout_;
  const GridFrame& frame_;
  float sea_m_;
  std::vector<std::vector<Flat>> flats_;  ///< by the tile that they belong to
  std::vector<std::set<int>> owners_;
};

}  // namespace seamount::tiles
