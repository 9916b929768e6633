// Which way water runs, and in which order cells must be visited so that every valley drains.
//
// A cell drains to a lower neighbour, one of the two corners of the steepest facet around it (Tarboton 1997), drawn so
// that water follows the slope on average and not the eight directions of the grid (cf. P1 sec. 5.1). Depressions are
// lakes: their water climbs over the lowest pass along the reversed path from their floor (geom/water/flow.h), so the
// water level of a cell is the greatest height on its way out. Roots are sea cells and the outlets of the border.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"
#include "seamount/model/grid.h"
#include "seamount/ops/erosion/sea.h"

namespace seamount::erosion {

/// Where water leaves the map: border cells as low as any within `reach_m` along the border (but for a gradient of
/// 0.5 %). All of a level border is outlet; of a rough one only where valleys leave. 1: outlet.
Grid<uint8_t> border_outlets(const HeightField& surface, double reach_m);

/// The outlets of a grid of twice the size: of the border cells within a coarse outlet those that are lowest.
Grid<uint8_t> refined_outlets(const Grid<uint8_t>& coarse, const HeightField& fine);

class Drainage {
 public:
  static constexpr uint8_t kTrunk = 255;

  /// Routes water over a surface. Without a seed each cell drains to the nearer corner of its facet. `room` is of the
  /// surface's size and spent. REQUIRES: one cell is a root (border_outlets makes one). About 70 ns per cell, more on a
  /// rough surface; receivers are found in parallel.
  void route(const HeightField& surface, const Grid<uint8_t>& outlets, const Sea& sea, std::optional<Seed> seed,
             ScalarField& room, const RunContext& run);

  /// Every cell, each after its receiver.
  std::span<const int32_t> order() const { return order_; }
  /// For parallel work the order begins with the trunk, the cells that much water passes through, and goes on with
  /// parts: whole catchments that drain to the trunk or off the map, some ten thousand cells each, at most 200. Trunk
  /// and parts depend on the ground alone.
  std::span<const int32_t> trunk() const { return cells(0, part_begins_.front()); }
  size_t parts() const { return part_begins_.size() - 1; }
  std::span<const int32_t> part(size_t index) const { return cells(part_begins_[index], part_begins_[index + 1]); }
  /// Index of a cell's part, or kTrunk.
  uint8_t part_of(int32_t cell) const { return part_of_.data()[cell]; }
  uint8_t direction(int32_t cell) const { return direction_.data()[cell]; }
  bool is_root(int32_t cell) const { return direction(cell) == geom::kOutlet; }
  /// REQUIRES: not a root.
  int32_t receiver(int32_t cell) const { return cell + offset_[direction(cell)]; }
  /// The cell beside a cell, `turn` eighths of a circle from the way its water takes. REQUIRES: not a root, not on the
  /// border.
  int32_t beside(int32_t cell, int turn) const { return cell + offset_[(direction(cell) + turn) & 7]; }
  /// Metres to the receiver.
  float distance(int32_t cell) const { return distance_[direction(cell)]; }

 private:
  void choose_receivers(const HeightField& surface, const Grid<uint8_t>& outlets, const Sea& sea,
                        std::optional<Seed> seed, const RunContext& run);
  void order_trees(const RunContext& run);
  void divide(ScalarField& upstream);
  std::span<const int32_t> cells(size_t begin, size_t end) const { return order().subspan(begin, end - begin); }

  geom::FlowDirections direction_;
  std::vector<int32_t> order_;
  std::vector<size_t> part_begins_;  ///< in the order, and its end
  Grid<uint8_t> part_of_;
  std::array<int32_t, 8> offset_ = {};
  std::array<float, 8> distance_ = {};
};

}  // namespace seamount::erosion
