#include "seamount/ops/hydrology/breach.h"

#include <algorithm>
#include <queue>
#include <vector>

#include "seamount/geom/water/flow.h"

namespace seamount::hydrology {
namespace {

/// Dijkstra's search from one pit after the other, over one set of marks.
class Breacher {
 public:
  Breacher(HeightField& terrain, float sea, int max_steps, float max_cut)
      : terrain_(terrain),
        sea_(sea),
        max_steps_(max_steps),
        max_cut_(max_cut),
        round_(terrain.frame(), 0),
        back_(terrain.frame()),
        steps_(geom::flow_steps(terrain.width())) {}

  void breach(int32_t pit) {
    const float floor = terrain_.data()[pit];
    ++rounds_;
    open_ = {};
    open_.push({0.0F, 0, pit, geom::kPit});
    while (!open_.empty()) {
      const Front front = open_.top();
      open_.pop();
      if (round_.data()[front.cell] == rounds_) continue;
      round_.data()[front.cell] = rounds_;
      back_.data()[front.cell] = front.back;
      if (front.cell != pit && is_way_out(front.cell, floor)) return cut(front.cell, floor);
      if (front.steps < max_steps_) expand(front, floor);
    }
  }

 private:
  struct Front {
    float cost;
    int32_t steps;
    int32_t cell;
    uint8_t back;                               ///< direction to where the search came from
    bool operator<(const Front& other) const {  // for a queue that gives the cheapest first
      if (cost != other.cost) return cost > other.cost;
      return steps != other.steps ? steps > other.steps : cell > other.cell;
    }
  };

  bool is_way_out(int32_t cell, float floor) const {
    const float z = terrain_.data()[cell];
    const int x = cell % terrain_.width(), y = cell / terrain_.width();
    return z < floor || z <= sea_ || x == 0 || y == 0 || x == terrain_.width() - 1 || y == terrain_.height() - 1;
  }

  void expand(const Front& front, float floor) {
    for (uint8_t k = 0; k < 8; ++k) {
      // No way leads on from the border, so all neighbours exist.
      const auto other = static_cast<int32_t>(front.cell + steps_[k]);
      if (round_.data()[other] == rounds_) continue;
      const float depth = std::max(0.0F, terrain_.data()[other] - floor);
      if (depth > max_cut_) continue;
      open_.push(
          {front.cost + depth * geom::kFlowLength[k], front.steps + 1, other, static_cast<uint8_t>((k + 4) % 8)});
    }
  }

  void cut(int32_t cell, float floor) {
    for (; back_.data()[cell] != geom::kPit; cell = static_cast<int32_t>(cell + steps_[back_.data()[cell]]))
      terrain_.data()[cell] = std::min(terrain_.data()[cell], floor);
  }

  HeightField& terrain_;
  float sea_;
  int max_steps_;
  float max_cut_;
  Grid<int32_t> round_;  ///< of the last search that settled a cell
  Grid<uint8_t> back_;
  std::array<int64_t, 8> steps_;
  std::priority_queue<Front> open_;
  int32_t rounds_ = 0;
};

}  // namespace

void breach_depressions(HeightField& terrain, float sea_level_m, int max_steps, float max_cut_m,
                        const RunContext& run) {
  const geom::FlowDirections directions = geom::flow_directions(terrain, sea_level_m, run);
  std::vector<int32_t> pits;
  for (int64_t i = 0; i < terrain.frame().cells(); ++i)
    if (directions.data()[i] == geom::kPit) pits.push_back(static_cast<int32_t>(i));
  std::sort(pits.begin(), pits.end(), [&](int32_t a, int32_t b) {
    const float za = terrain.data()[a], zb = terrain.data()[b];
    return za != zb ? za < zb : a < b;
  });
  Breacher breacher(terrain, sea_level_m, max_steps, max_cut_m);
  for (const int32_t pit : pits) {
    run.check_cancelled();
    breacher.breach(pit);
  }
}

}  // namespace seamount::hydrology
