// Flats that lie over the borders of tiles: found tile by tile, drained each as a whole.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"
#include "seamount/tiles/borders.h"

namespace seamount::tiles {

class BorderFlats {
 public:
  BorderFlats(const Layout& layout, const GridFrame& frame, float sea_m, const RunContext& run);

  /// Finds the flats that reach a tile's rim. `surface`: filled heights of the tile and a ring of one cell around it,
  /// as far as the whole goes. Every tile, in order.
  void look_at(int tile, const HeightField& surface);

  /// Drains them. `read` gives filled heights; `check` may throw for a rectangle that is too large.
  void drain(const std::function<HeightField(const Rect&)>& read, const std::function<void(const GridFrame&)>& check);

  /// Sets the directions of their cells in a tile.
  void put(int tile, geom::FlowDirections& codes) const;

 private:
  struct Part {
    Rect around;  ///< of the whole
    CellPlace first;
  };
  struct Code {
    int32_t cell;  ///< of its tile
    uint8_t code;
  };

  void drain_one(const Rect& around, const CellPlace& first, const std::function<HeightField(const Rect&)>& read,
                 const std::function<void(const GridFrame&)>& check);

  const Layout& layout_;
  const GridFrame& frame_;
  float sea_m_;
  const RunContext& run_;
  std::vector<std::vector<int32_t>> part_of_rim_;  ///< by tile and rim number; -1: no flat
  std::vector<std::vector<float>> height_of_rim_;
  std::vector<Part> parts_;
  std::map<int, std::vector<Code>> codes_;
};

}  // namespace seamount::tiles
