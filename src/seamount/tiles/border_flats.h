// Flats that lie over the borders of tiles: how many steps their rim cells are from where they drain, and from higher
// ground (geom/water/piece_flats.h).
//
// Shortest ways over a graph of all rim cells in memory: neighbours across borders are a step apart, and rim cells of a
// small part of a flat are linked pair by pair. Through large parts ways are walked on the tile's cells, from all rim
// cells at once that were reached since it was walked last: such tiles are asked for in rounds, those first that are
// reached with the fewest steps. Through a wide lake that is once or twice a tile; at worst as often as its shortest
// ways come back into one part of it from beside the tile.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/water/piece_flats.h"
#include "seamount/tiles/borders.h"

namespace seamount::tiles {

/// What steps are counted from: index of what there is of each.
inline constexpr size_t kFromOutlets = 0, kFromHigher = 1;
using RimSteps = std::array<std::vector<int32_t>, 2>;

/// What a tile says of the flats that reach its rim, by rim number; nothing where there are none.
struct TileFlats {
  RimSteps steps;  ///< counted within the tile; geom::kNoFlat and geom::kFarAway
  geom::RimLinks links;
};
TileFlats look_at_flats(const geom::FlowDirections& marked, const RunContext& run);

/// A rim cell that is reached with fewer steps than before.
struct Reached {
  int32_t node, from, steps;
};

class BorderFlats {
 public:
  /// `first_node`: of each tile's rim, and behind the last. Both must outlive this.
  BorderFlats(const Layout& layout, const std::vector<int32_t>& first_node);

  /// In the order of tiles, and then settle().
  void add(int tile, const TileFlats& flats);
  void settle();

  /// The tiles to be walked now, all of which must be, and what lower() is told of it before they are asked for again.
  /// None: all is known.
  std::vector<int> next_tiles();
  void lower(const std::vector<Reached>& reached);
  /// Where a tile is entered in this round, by its cells, and what is reached from there.
  std::vector<Reached> walk(int tile, const geom::FlowDirections& marked, const RunContext& run) const;
  /// Tiles that wait to be walked.
  int waiting() const;

  /// Gives the marked cells of a tile their directions, once all is known.
  void aim(int tile, geom::FlowDirections& marked, const RunContext& run) const;

 private:
  struct Link {
    int32_t to, steps;
  };
  using Entered = std::array<std::vector<int32_t>, 2>;  ///< nodes, by what is counted from

  RimPlace place_of(int32_t node) const;
  int32_t node_of(const RimPlace& place) const { return first_node_[static_cast<size_t>(place.tile)] + place.rim; }
  int32_t steps_of(size_t from, int32_t node) const { return steps_[from][static_cast<size_t>(node)]; }
  void sort_links();
  void settle(size_t from);
  bool lower(size_t from, int32_t node, int64_t steps);
  geom::FlatSteps all_steps(int tile, const geom::FlowDirections& marked, size_t from, const RunContext& run) const;

  const Layout& layout_;
  const std::vector<int32_t>& first_node_;
  RimSteps steps_;                               ///< by node
  std::vector<uint8_t> linked_;                  ///< by node
  std::array<std::vector<uint8_t>, 2> entered_;  ///< by node: from beside its tile, since that was walked
  std::vector<Entered> waits_, walked_;          ///< by tile: entered nodes, and those of this round
  std::vector<geom::FlatLink> told_;             ///< links between nodes, until they are sorted
  std::vector<Link> links_;
  std::vector<int32_t> first_link_;  ///< by node
  std::array<std::priority_queue<std::pair<int32_t, int32_t>, std::vector<std::pair<int32_t, int32_t>>, std::greater<>>,
             2>
      queue_;  ///< steps and node
};

}  // namespace seamount::tiles
