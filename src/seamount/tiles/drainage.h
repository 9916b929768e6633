// Filling and flow on a raster in tiles (Barnes 2016, 2017), with the bytes of the whole: what geom::raise_inland,
// fill_depressions, flow_directions, tilt_flats and flow_accumulation make of it.
//
// Every tile is read a few times; between passes stand graphs of the tiles' rims in memory, some 40 bytes a rim cell.
// Flats that lie across borders are drained one by one on the rectangle around them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "seamount/geom/water/pieces.h"
#include "seamount/model/grid.h"
#include "seamount/tiles/borders.h"
#include "seamount/tiles/tiled_ways.h"
#include "seamount/tiles/world.h"

namespace seamount::tiles {

class Drainage {
 public:
  /// Of the raster `terrain` for the step `step`, under whose key the intermediate rasters lie. `sea_m`: kNoSea for
  /// none. Cells without a value are where water leaves.
  Drainage(const World& world, size_t step, OutputOf terrain, float sea_m, std::optional<double> min_sea_m2,
           const RunContext& run);

  const Layout& layout() const { return layout_; }
  const GridFrame& frame() const { return frame_; }

  /// Which waters below sea level are no sea. fill() does it first. Throws NeedsWhole as it does.
  void find_hollows(const RunContext& run);
  /// The terrain with unknown cells marked and all hollows at one height. After find_hollows().
  HeightField ground(int tile, float hollow_m) const;

  // In this order, as far as they are wanted; each reports its own progress.
  /// The filled surface, unknown cells at geom::kUnknownGround. Throws NeedsWhole for enclosed waters below sea level
  /// of a hundredth of the terrain and more, which are sea or not by the lowest way out of them.
  void fill(const RunContext& run);
  /// The directions on it.
  void direct(const RunContext& run);
  /// Lets filled ground fall along the directions, in place of the filled surface that filled() gives.
  void tilt(const RunContext& run);
  /// How many cells drain through each.
  void gather(const RunContext& run);

  /// The catchments, once cells are gathered: numbers of their mouths, from the largest on.
  void number_basins(const RunContext& run);

  /// A tile of the input, as it is.
  HeightField terrain(int tile) const;
  HeightField filled(int tile) const;
  geom::FlowDirections directions(int tile) const;
  Grid<uint64_t> cells(int tile) const;
  Grid<int32_t> basins(int tile) const;  ///< 0 for open water
  /// How many catchments have at least so many cells, about.
  size_t basins_of_at_least(double cells) const;

  /// Any window of the terrain with unknown cells marked, and of the filled surface, before it is tilted.
  HeightField bed(const Rect& rect) const;
  HeightField level(const Rect& rect) const { return filled_window(rect); }

  /// Removes what was kept on disk.
  void forget() const noexcept;

 private:
  /// With hollows raised out of the sea.
  HeightField ground(int tile) const;
  HeightField marked(int tile) const;
  std::vector<geom::Spill> all_spills(const RunContext& run);
  void fill_tiles(const std::vector<float>& levels, const RunContext& run);
  HeightField filled_window(const Rect& rect) const;
  HeightField with_ring(int tile) const;
  int32_t entered_from(int tile, int32_t cell, uint8_t code) const;
  void follow_to_mouths(const std::vector<int32_t>& next, const std::vector<int32_t>& end);
  int32_t basin_at(int tile, int32_t cell) const;
  void each_tile(const RunContext& run, const std::function<void(int tile)>& body) const;
  std::shared_ptr<const StoredRaster> store(const std::string& name) const;
  int32_t node_of(const RimPlace& place) const { return first_node_[static_cast<size_t>(place.tile)] + place.rim; }

  const World& world_;
  size_t step_;
  OutputOf terrain_;
  float sea_m_;
  std::optional<double> min_sea_m2_;
  RunContext run_;  ///< for what reports nothing
  GridFrame frame_;
  Layout layout_;
  std::vector<int32_t> first_node_;         ///< number of a tile's first rim cell among all of them, from 1 on
  std::vector<std::vector<bool>> hollows_;  ///< of each tile's waters
  std::shared_ptr<const StoredRaster> filled_, codes_;
  std::vector<float> tilted_;       ///< by node: heights of rims once they fall; empty: filled as it is
  std::vector<uint64_t> entering_;  ///< by node: what enters a tile there
  struct Numbered {
    int32_t cell, basin;
  };
  std::vector<std::vector<Numbered>> mouths_;  ///< of each tile, by cell
  std::vector<int32_t> basin_of_node_;         ///< of what is at a rim cell
  std::vector<uint64_t> drained_;              ///< by basins, from number 1 on
};

}  // namespace seamount::tiles
