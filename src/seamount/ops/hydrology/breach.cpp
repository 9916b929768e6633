#include "seamount/ops/hydrology/breach.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/geom/water/flow.h"
#include "seamount/ops/hydrology/lowest_ground.h"
#include "seamount/ops/hydrology/monotone_queue.h"

namespace seamount::hydrology {
namespace {

/// Costs are never negative, so their bits are in order; of equal costs fewer steps come first.
uint64_t key_of(float cost, int32_t steps) {
  return static_cast<uint64_t>(std::bit_cast<uint32_t>(cost)) << 32 | static_cast<uint32_t>(steps);
}
float cost_of(uint64_t key) { return std::bit_cast<float>(static_cast<uint32_t>(key >> 32)); }
int32_t steps_of(uint64_t key) { return static_cast<int32_t>(static_cast<uint32_t>(key)); }

class Breacher {
 public:
  Breacher(HeightField& terrain, float sea, int max_steps, float max_cut, const RunContext& run)
      : terrain_(terrain),
        lowest_(terrain),
        sea_(sea),
        max_steps_(max_steps),
        max_cut_(max_cut),
        place_(terrain.frame(), 0),
        steps_(geom::flow_steps(terrain.width())),
        run_(run) {}

  void breach(int32_t pit) {
    const float floor = terrain_.data()[pit];
    if (!may_reach_lower(pit, floor)) return;
    reached_.clear();
    queue_.clear();
    best_way_out_ = std::numeric_limits<uint64_t>::max();
    place_.data()[pit] = 0;
    reached_.push_back({0, pit, 0.0F, geom::kPit, false, false});
    queue_.push(0, pit);
    while (!queue_.empty()) {
      if (++taken_ % kTakenPerCheck == 0) run_.check_cancelled();
      queue_.take(batch_);
      for (const int32_t cell : batch_) {
        Reached& here = reached_[static_cast<size_t>(place_.data()[cell])];
        if (here.settled) continue;
        here.settled = true;
        if (here.way_out) return cut(cell, floor);
        if (steps_of(here.key) < max_steps_) expand(here, floor);
      }
    }
  }

 private:
  static constexpr int64_t kTakenPerCheck = 4096;

  struct Reached {
    uint64_t key;  ///< cost and steps of the best way from the pit so far
    int32_t cell;
    float depth;   ///< of the cut that it would need
    uint8_t back;  ///< direction to where the search came from
    bool settled, way_out;
  };

  bool is_border(int x, int y) const {
    return x <= 0 || y <= 0 || x >= terrain_.width() - 1 || y >= terrain_.height() - 1;
  }

  bool is_way_out(int32_t cell, float floor) const {
    const float z = terrain_.data()[cell];
    return z < floor || z <= sea_ || is_border(cell % terrain_.width(), cell / terrain_.width());
  }

  /// False where no way out lies within max_steps_, so that the search would look at all of that in vain.
  bool may_reach_lower(int32_t pit, float floor) const {
    const int x = pit % terrain_.width(), y = pit / terrain_.width(), far = max_steps_;
    if (is_border(x - far, y - far) || is_border(x + far, y + far)) return true;
    return lowest_.has_below(std::max(floor, std::nextafter(sea_, INFINITY)), x - far, y - far, x + far, y + far);
  }

  void expand(const Reached& from, float floor) {
    // No way leads on from the border, so all neighbours exist.
    const int32_t cell = from.cell, steps = steps_of(from.key) + 1;
    const float cost = cost_of(from.key);
    for (size_t k = 0; k < 8; ++k) {
      const auto other = static_cast<int32_t>(cell + steps_[k]);
      const auto back = static_cast<uint8_t>((k + 4) % 8);
      if (Reached* known = find(other)) {
        if (known->settled) continue;
        const uint64_t key = key_of(cost + known->depth * geom::kFlowLength[k], steps);
        if (key >= known->key || key > best_way_out_) continue;
        known->key = key;
        known->back = back;
        enqueue(*known);
        continue;
      }
      const float depth = std::max(0.0F, terrain_.data()[other] - floor);
      const uint64_t key = key_of(cost + depth * geom::kFlowLength[k], steps);
      if (depth > max_cut_ || key > best_way_out_) continue;
      place_.data()[other] = static_cast<int32_t>(reached_.size());
      reached_.push_back({key, other, depth, back, false, is_way_out(other, floor)});
      enqueue(reached_.back());
    }
  }

  Reached* find(int32_t cell) {
    const auto place = static_cast<size_t>(place_.data()[cell]);
    return place < reached_.size() && reached_[place].cell == cell ? &reached_[place] : nullptr;
  }

  void enqueue(const Reached& cell) {
    if (cell.way_out) best_way_out_ = cell.key;
    queue_.push(cell.key, cell.cell);
  }

  void cut(int32_t cell, float floor) {
    while (true) {
      const uint8_t back = find(cell)->back;
      if (back == geom::kPit) return;
      if (terrain_.data()[cell] > floor) {
        terrain_.data()[cell] = floor;
        lowest_.note_lowered(cell % terrain_.width(), cell / terrain_.width());
      }
      cell = static_cast<int32_t>(cell + steps_[back]);
    }
  }

  HeightField& terrain_;
  LowestGround lowest_;
  float sea_;
  int max_steps_;
  float max_cut_;
  Grid<int32_t> place_;  ///< of a cell among those reached; what an earlier search left there is told by the cell
  std::array<int64_t, 8> steps_;
  const RunContext& run_;
  std::vector<Reached> reached_;
  MonotoneQueue queue_;
  std::vector<int32_t> batch_;
  uint64_t best_way_out_ = 0;
  int64_t taken_ = 0;
};

}  // namespace

void breach_depressions(HeightField& terrain, float sea_level_m, int max_steps, float max_cut_m,
                        const RunContext& run) {
  std::vector<int32_t> pits;
  {
    const geom::FlowDirections directions = geom::flow_directions(terrain, sea_level_m, run);
    for (int64_t i = 0; i < terrain.frame().cells(); ++i)
      if (directions.data()[i] == geom::kPit) pits.push_back(static_cast<int32_t>(i));
  }
  std::sort(pits.begin(), pits.end(), [&](int32_t a, int32_t b) {
    const float za = terrain.data()[a], zb = terrain.data()[b];
    return za != zb ? za < zb : a < b;
  });
  Breacher breacher(terrain, sea_level_m, max_steps, max_cut_m, run);
  for (const int32_t pit : pits) {
    run.check_cancelled();
    breacher.breach(pit);
  }
}

}  // namespace seamount::hydrology
