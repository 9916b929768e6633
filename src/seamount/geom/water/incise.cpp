#include "seamount/geom/water/incise.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace seamount::geom {
namespace {

/// Every cell, each before the one that it drains to.
std::vector<int32_t> downstream_order(const FlowDirections& directions) {
  const auto steps = flow_steps(directions.width());
  const uint8_t* const code = directions.data();
  const auto count = static_cast<int64_t>(directions.size());
  std::vector<uint8_t> missing(directions.size(), 0);
  for (int64_t i = 0; i < count; ++i) {
    if (code[i] < 8) ++missing[static_cast<size_t>(i + steps[code[i]])];
  }
  std::vector<int32_t> order;
  order.reserve(directions.size());
  constexpr uint8_t kPlaced = 255;
  for (int64_t i = 0; i < count; ++i) {
    for (int64_t cell = i; missing[static_cast<size_t>(cell)] == 0;) {
      missing[static_cast<size_t>(cell)] = kPlaced;
      order.push_back(static_cast<int32_t>(cell));
      if (code[cell] >= 8) break;
      cell += steps[code[cell]];
      --missing[static_cast<size_t>(cell)];
    }
  }
  return order;
}

class Sweeps {
 public:
  Sweeps(const HeightField& terrain, const FlowDirections& directions, const Grid<uint32_t>& cells,
         const Incision& incision)
      : terrain_(terrain.data()),
        code_(directions.data()),
        cells_(cells.data()),
        incision_(incision),
        steps_(flow_steps(terrain.width())),
        cell_m_(static_cast<float>(terrain.cell_m())),
        order_(downstream_order(directions)),
        out_{terrain, ScalarField(terrain.frame(), 0.0F)} {}

  /// Where each cell comes to lie, given the load.
  void solve() {
    float* const level = out_.heights.data();
    const float* const load = out_.load.data();
    for (size_t k = order_.size(); k-- > 0;) {
      const int32_t i = order_[k];
      if (code_[i] >= 8) {
        level[i] = terrain_[i];
        continue;
      }
      const float base = level[i + steps_[code_[i]]], length = kFlowLength[code_[i]];
      const auto drained = static_cast<float>(cells_[i]);
      const float rate = incision_.rate * std::sqrt(std::max(0.0F, drained - incision_.channel_cells)) / length;
      const float top = terrain_[i] + incision_.deposition * load[i] / drained;
      const float cut = top > base ? (top + rate * base) / (1 + rate) : base;
      level[i] = std::min(cut, base + incision_.steepest * length * cell_m_);
    }
  }

  /// The load that goes with it; heights become what there is to lay down.
  void carry() {
    float* const level = out_.heights.data();
    float* const load = out_.load.data();
    std::fill(out_.load.cells().begin(), out_.load.cells().end(), 0.0F);
    for (const int32_t i : order_) {
      if (code_[i] >= 8) continue;
      const float change = std::min(level[i] - terrain_[i], load[i]);
      level[i] = terrain_[i] + change;
      load[i + steps_[code_[i]]] += load[i] - change;
    }
  }

  Incised take() { return std::move(out_); }

 private:
  const float* terrain_;
  const uint8_t* code_;
  const uint32_t* cells_;
  Incision incision_;
  std::array<int64_t, 8> steps_;
  float cell_m_;
  std::vector<int32_t> order_;
  Incised out_;
};

}  // namespace

Incised incise(const HeightField& terrain, const FlowDirections& directions, const Grid<uint32_t>& cells,
               const Incision& incision, const RunContext& run) {
  Sweeps sweeps(terrain, directions, cells, incision);
  for (int sweep = 0; sweep <= (incision.deposition > 0 ? incision.sweeps : 0); ++sweep) {
    run.check_cancelled();
    sweeps.solve();
    sweeps.carry();
  }
  return sweeps.take();
}

void limit_rise(HeightField& heights, float steepest) {
  const int width = heights.width(), height = heights.height();
  const float side = steepest * static_cast<float>(heights.cell_m()), corner = side * kFlowLength[1];
  const auto limit = [&](int x, int y, int dy, int way) {  // by those that a sweep has passed
    float& z = heights(x, y);
    if (heights.contains(x - way, y)) z = std::min(z, heights(x - way, y) + side);
    if (!heights.contains(x, y + dy)) return;
    z = std::min(z, heights(x, y + dy) + side);
    for (const int dx : {-1, 1}) {
      if (heights.contains(x + dx, y + dy)) z = std::min(z, heights(x + dx, y + dy) + corner);
    }
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) limit(x, y, -1, 1);
    for (int x = width; x-- > 0;) limit(x, y, -1, -1);
  }
  for (int y = height; y-- > 0;) {
    for (int x = width; x-- > 0;) limit(x, y, 1, -1);
    for (int x = 0; x < width; ++x) limit(x, y, 1, 1);
  }
}

}  // namespace seamount::geom
