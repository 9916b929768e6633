#include "seamount/geom/water/incise.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/base/parallel.h"

namespace seamount::geom {
namespace {

/// The steepest slope of a cell that so many cells drain through.
float steepest_of(const Incision& incision, float drained) {
  if (incision.hollowed <= 0.0F) return incision.steepest;
  return incision.steepest / (1.0F + incision.hollowed * std::log2(1.0F + drained / incision.hollow_cells));
}

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

/// A cell in downstream order, and what of it stays from sweep to sweep.
struct Step {
  int32_t cell, receiver;  ///< kNowhere: an outlet
  float rate;              ///< K t sqrt(Q) over the way to the receiver
  float most;              ///< by which it may stand over the receiver
  float settles;           ///< share of the load that it would lay down
};
constexpr int32_t kNowhere = -1;

class Sweeps {
 public:
  Sweeps(const HeightField& terrain, const FlowDirections& directions, const Grid<uint32_t>& cells,
         const Incision& incision, const RunContext& run)
      : terrain_(terrain.data()), out_{terrain, ScalarField(terrain.frame(), 0.0F)} {
    const auto steps = flow_steps(terrain.width());
    const auto cell_m = static_cast<float>(terrain.cell_m());
    const std::vector<int32_t> order = downstream_order(directions);
    steps_.resize(order.size());
    constexpr int64_t kGrain = 1 << 15;
    parallel_blocks(run, static_cast<int64_t>(order.size()), kGrain, [&](int64_t begin, int64_t end) {
      for (int64_t k = begin; k < end; ++k) {
        const int32_t cell = order[static_cast<size_t>(k)];
        const uint8_t code = directions.data()[cell];
        if (code >= 8) {
          steps_[static_cast<size_t>(k)] = {cell, kNowhere, 0, 0, 0};
          continue;
        }
        const auto drained = static_cast<float>(cells.data()[cell]);
        const float length = kFlowLength[code], channel = std::max(0.0F, drained - incision.channel_cells);
        steps_[static_cast<size_t>(k)] = {
            cell, static_cast<int32_t>(cell + steps[code]), incision.rate * std::sqrt(channel) / length,
            steepest_of(incision, drained) * length * cell_m, incision.deposition / drained};
      }
    });
  }

  /// Where each cell comes to lie, given the load.
  void solve() {
    float* const level = out_.heights.data();
    const float* const load = out_.load.data();
    for (size_t k = steps_.size(); k-- > 0;) {
      const Step& step = steps_[k];
      const float ground = terrain_[step.cell];
      if (step.receiver == kNowhere) {
        level[step.cell] = ground;
        continue;
      }
      const float base = level[step.receiver], top = ground + step.settles * load[step.cell];
      const float cut = top > base ? (top + step.rate * base) / (1 + step.rate) : base;
      level[step.cell] = std::min(cut, base + step.most);
    }
  }

  /// The load that goes with it; heights become what there is to lay down.
  void carry() {
    float* const level = out_.heights.data();
    float* const load = out_.load.data();
    std::fill(out_.load.cells().begin(), out_.load.cells().end(), 0.0F);
    for (const Step& step : steps_) {
      if (step.receiver == kNowhere) continue;
      const float change = std::min(level[step.cell] - terrain_[step.cell], load[step.cell]);
      level[step.cell] = terrain_[step.cell] + change;
      load[step.receiver] += load[step.cell] - change;
    }
  }

  Incised take() { return std::move(out_); }

 private:
  const float* terrain_;
  std::vector<Step, detail::UninitialisedAllocator<Step>> steps_;
  Incised out_;
};

}  // namespace

Incised incise(const HeightField& terrain, const FlowDirections& directions, const Grid<uint32_t>& cells,
               const Incision& incision, const RunContext& run) {
  Sweeps sweeps(terrain, directions, cells, incision, run);
  for (int sweep = 0; sweep <= (incision.deposition > 0 ? incision.sweeps : 0); ++sweep) {
    run.check_cancelled();
    sweeps.solve();
    sweeps.carry();
  }
  return sweeps.take();
}

void limit_rise(HeightField& heights, const Grid<uint32_t>& cells, const Incision& incision, const RunContext& run) {
  const int width = heights.width(), height = heights.height();
  const auto cell_m = static_cast<float>(heights.cell_m());
  Grid<float> rise(heights.frame());
  parallel_rows(run, width, height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < width; ++x) rise(x, y) = cell_m * steepest_of(incision, static_cast<float>(cells(x, y)));
  });
  const auto limit = [&](int64_t cell, float* z) {
    constexpr float kLeast = 0.7071F;  // of a cell's rise by which it stands over the lower of two ways at least
    const float a = std::min(z[-1], z[1]), b = std::min(z[-width], z[width]), most = rise.data()[cell];
    const float corner = std::min({z[-width - 1], z[-width + 1], z[width - 1], z[width + 1]}) + kFlowLength[1] * most;
    if (*z <= std::min(corner, std::min(a, b) + kLeast * most)) return;
    const float apart = a - b;
    const float straight =
        std::abs(apart) >= most ? std::min(a, b) + most : 0.5F * (a + b + std::sqrt(2 * most * most - apart * apart));
    *z = std::min({*z, straight, corner});
  };
  const auto both_ways = [&](int y) {
    run.check_cancelled();
    const int64_t row = static_cast<int64_t>(y) * width;
    for (int x = 1; x + 1 < width; ++x) limit(row + x, heights.data() + row + x);
    for (int x = width - 1; --x > 0;) limit(row + x, heights.data() + row + x);
  };
  for (int y = 1; y + 1 < height; ++y) both_ways(y);
  for (int y = height - 1; --y > 0;) both_ways(y);
}

}  // namespace seamount::geom
