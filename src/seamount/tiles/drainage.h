// Filling and flow on a raster in tiles (Barnes 2016, 2017), with the bytes of the whole: what geom::raise_inland,
// fill_depressions, flow_directions, tilt_flats and flow_accumulation make of it.
//
// Each pass makes something of every tile, spread over ranks and threads, and leaves it on disk: rasters, and what the
// tile says of its rim. From what all tiles say every rank makes the same graph in memory, some 40 bytes a rim cell.
// Flats that lie across borders are drained from the steps of their rim cells (border_flats.h).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "seamount/geom/water/pieces.h"
#include "seamount/model/grid.h"
#include "seamount/tiles/borders.h"
#include "seamount/tiles/stored_notes.h"
#include "seamount/tiles/tiled_ways.h"
#include "seamount/tiles/world.h"

namespace seamount::tiles {

class BorderFlats;
struct Reached;

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

  // In this order, as far as they are wanted, by all ranks; each reports its own progress.
  /// The filled surface, unknown cells at geom::kUnknownGround. Throws NeedsWhole for enclosed waters below sea level
  /// of a hundredth of the terrain and more, which are sea or not by the lowest way out of them.
  void fill(const RunContext& run);
  void direct(const RunContext& run);  ///< the directions on it
  /// Lets filled ground fall along the directions, in place of the filled surface that filled() gives.
  void tilt(const RunContext& run);
  void gather(const RunContext& run);  ///< how many cells drain through each

  /// The catchments, once cells are gathered: numbers of their mouths, from the largest on.
  void number_basins(const RunContext& run);

  /// Calls body(tile) for all tiles, spread over ranks and threads: for what is left on disk.
  void each_tile(const RunContext& run, const std::function<void(int tile)>& body) const;
  std::shared_ptr<const StoredNotes> notes(const std::string& name) const;  ///< under the step's key

  /// A tile of the input, as it is.
  HeightField terrain(int tile) const;
  HeightField filled(int tile) const;
  geom::FlowDirections directions(int tile) const;
  Grid<uint64_t> cells(int tile) const;
  Grid<int32_t> basins(int tile) const;           ///< 0 for open water
  size_t basins_of_at_least(double cells) const;  ///< about how many have so many cells

  /// Any window of the terrain with unknown cells marked, and of the filled surface, before it is tilted.
  HeightField bed(const Rect& rect) const;
  HeightField level(const Rect& rect) const { return filled_window(rect); }

  /// Removes what was kept on disk.
  void forget() const;

 private:
  using Raster = std::shared_ptr<const StoredRaster>;
  using Notes = std::shared_ptr<const StoredNotes>;

  /// With hollows raised out of the sea.
  HeightField ground(int tile) const;
  bool is_hollow(const geom::PieceWater& water) const;
  void flood_tiles(const RunContext& run);
  void find_levels();
  HeightField filled_window(const Rect& rect) const;
  HeightField with_ring(int tile) const;
  void direct_tiles(const RunContext& run);
  void walk_flats(BorderFlats& flats, const RunContext& run) const;
  std::vector<Reached> walk_round(const BorderFlats& flats, const std::vector<int>& tiles) const;
  void note_rises(int tile) const;
  void gather_tiles(const RunContext& run);
  int32_t entered_from(int tile, int32_t cell, uint8_t code) const;
  void note_mouths(int tile) const;
  void follow_to_mouths(const std::vector<int32_t>& next, const std::vector<int32_t>& end);
  int32_t basin_at(int tile, int32_t cell) const;
  bool all_have(const std::function<bool()>& complete) const;
  Raster raster(const std::string& name, const recipe::Kind& kind) const;
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
  Raster flooded_, basins_;                 ///< each tile's own level, and over which rim cell (+ 1) its water leaves
  Raster marked_, directions_;              ///< flats across borders marked, and drained
  Notes waters_, spills_, flats_, rises_, exits_, ends_;
  Notes walks_;                     ///< what was reached in each round through flats
  std::vector<float> levels_;       ///< by node: at which it overflows
  std::vector<float> tilted_;       ///< by node: heights of rims once they fall; empty: filled as it is
  std::vector<uint64_t> entering_;  ///< by node: what enters a tile there
  std::vector<std::unordered_map<int32_t, int32_t>> mouths_;  ///< of each tile: basins by cell
  std::vector<int32_t> basin_of_node_;                        ///< of what is at a rim cell
  std::vector<uint64_t> basin_cells_;                         ///< by basins, from number 1 on
};

}  // namespace seamount::tiles
