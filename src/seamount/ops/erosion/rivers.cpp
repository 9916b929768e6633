#include "seamount/ops/erosion/rivers.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/ops/erosion/repose.h"

namespace seamount::erosion {
namespace {

/// Rivers of a few cells cut less than their discharge says: a coarse cell is mostly slope, and without this erosion
/// would grow with the size of the cells. What flows off this many cells does not cut, but for the share below.
constexpr double kHeadCells = 2.0;
constexpr float kHeadShare = 0.03F;

/// Calls f(part) for the parts of a drainage, side by side.
template <class F>
void for_parts(const Drainage& drainage, const RunContext& run, const F& f) {
  parallel_blocks(run, static_cast<int64_t>(drainage.parts()), 1,
                  [&](int64_t part, int64_t) { f(static_cast<size_t>(part)); });
}

/// What flows from a part into the trunk, kept back until all parts are done.
struct Inflow {
  int32_t cell;
  float amount;
};

/// Calls pass(cell, part, add) for all cells, each before its receiver: the parts side by side, then the trunk, which
/// is the last part. add(amount) passes an amount on to the receiver's cell of `to`.
template <class Pass>
void flow_down(const Drainage& drainage, float* to, const RunContext& run, const Pass& pass) {
  std::vector<std::vector<Inflow>> inflows(drainage.parts());
  for_parts(drainage, run, [&](size_t part) {
    const auto cells = drainage.part(part);
    for (size_t k = cells.size(); k-- > 0;) {
      pass(cells[k], part, [&](float amount) {
        const int32_t receiver = drainage.receiver(cells[k]);
        if (drainage.part_of(receiver) == Drainage::kTrunk) {
          inflows[part].push_back({receiver, amount});
        } else {
          to[receiver] += amount;
        }
      });
    }
  });
  for (const auto& own : inflows) {
    for (const auto& [cell, amount] : own) to[cell] += amount;
  }
  const auto trunk = drainage.trunk();
  for (size_t k = trunk.size(); k-- > 0;) {
    pass(trunk[k], drainage.parts(), [&](float amount) { to[drainage.receiver(trunk[k])] += amount; });
  }
}

double area_of(const Ground& ground) { return ground.surface.cell_m() * ground.surface.cell_m(); }

/// How fast a layer goes down towards the base level, times the step: K dt sqrt(Q) / dx.
struct Rates {
  float sediment, rock, bedrock;
};

/// Height after a step of dh/dt = -F (h - base), F by layer: backward Euler in each layer, in turn. `top` > base.
float cut_down(float top, float base, float sediment, float rock, const Rates& rates) {
  float time = 1.0F;
  for (const auto& [thickness, rate] : {std::pair{sediment, rates.sediment}, {rock, rates.rock}}) {
    if (thickness <= 0.0F) continue;
    const float reached = (top + time * rate * base) / (1.0F + time * rate);
    const float bottom = top - thickness;
    if (reached >= bottom) return reached;
    time -= (top - bottom) / (rate * (bottom - base));
    top = bottom;
    if (time <= 0.0F) return top;
  }
  return (top + time * rates.bedrock * base) / (1.0F + time * rates.bedrock);
}

/// Ground that creep has moved, before rivers cut it: where its top is, and how much it resists going anywhere else.
struct Crept {
  float top;
  float stiffness;  ///< 1 + D dt (neighbours) / dx^2
};

/// The sweeps of one step over one ground.
class Step {
 public:
  Step(Ground& ground, const Site& site, const Drainage& drainage, const ScalarField& discharge, const Rivers& rivers,
       ScalarField& load, ScalarField& level)
      : ground_(ground),
        site_(site),
        drainage_(drainage),
        surface_(ground.surface.data()),
        discharge_(discharge.data()),
        load_(load.data()),
        level_(level.data()),
        width_(ground.frame().width),
        height_(ground.frame().height),
        sea_(static_cast<float>(rivers.sea_m)),
        rate_(static_cast<float>(rivers.erodibility * rivers.years)),
        rock_ease_(static_cast<float>(rivers.rock_ease)),
        sediment_ease_(static_cast<float>(rivers.sediment_ease)),
        threshold_(static_cast<float>(rivers.rain_m * rivers.channel_m2)),
        heads_(static_cast<float>(rivers.rain_m * kHeadCells * area_of(ground))),
        settling_(static_cast<float>(rivers.deposition * rivers.rain_m * area_of(ground))),
        creep_(static_cast<float>(rivers.creep_m2 * rivers.years / area_of(ground))) {}

  /// Where each cell would come to lie, from the outlets up, given the load. Below a lake's level: that level.
  void solve(const RunContext& run) {
    const auto all = [&](std::span<const int32_t> cells) {
      for (const int32_t cell : cells)
        level_[cell] = drainage_.is_root(cell) ? std::max(surface_[cell], sea_) : level_of(cell);
    };
    all(drainage_.trunk());
    for_parts(drainage_, run, [&](size_t part) { all(drainage_.part(part)); });
  }

  /// Carries the load downstream. `moving`: changes the ground; else only tells the load of the next sweep.
  template <bool moving>
  void carry(Ledger& ledger, const RunContext& run) {
    std::fill_n(load_, drainage_.order().size(), 0.0F);
    std::vector<Ledger> ledgers(drainage_.parts() + 1);
    flow_down(drainage_, load_, run, [&](int32_t cell, size_t part, const auto& add) {
      if (drainage_.is_root(cell)) {
        if (moving) leave(cell, ledgers[part]);
      } else {
        add(pass_on<moving>(cell, ledgers[part]));
      }
    });
    if (!moving) return;
    const double area = area_of(ground_);
    for (const Ledger& own : ledgers) {
      ledger.eroded += own.eroded * area;
      ledger.deposited += own.deposited * area;
      ledger.exported += own.exported * area;
    }
  }

 private:
  /// What comes to an outlet of the border leaves the map.
  void leave(int32_t cell, Ledger& ledger) {
    if (surface_[cell] < sea_) return;
    ledger.exported += load_[cell];
    load_[cell] = 0.0F;
  }

  /// Lets a cell take its share of the load or add to it, and returns what goes on.
  template <bool moving>
  float pass_on(int32_t cell, Ledger& ledger) {
    const float change = level_[cell] - surface_[cell];
    float leaving = load_[cell];
    if (change < 0.0F) {
      leaving -= change;
      if (moving) ground_.lower(cell, -change);
      ledger.eroded -= change;
    } else if (value_or_one(site_.mask, cell) > 0.0F) {
      const float laid = std::min(change, leaving);
      leaving -= laid;
      if (moving) ground_.bury(cell, laid);
      ledger.deposited += laid;
    }
    if (moving) load_[cell] = 0.0F;
    return leaving;
  }

  float level_of(int32_t cell) const {
    const float base = level_[drainage_.receiver(cell)], distance = drainage_.distance(cell);
    const float mask = value_or_one(site_.mask, cell), hardness = value_or_one(site_.hardness, cell);
    const float water = discharge_[cell];
    const float in_channel = std::max(0.0F, water - threshold_);
    const float laid = mask * load_[cell] * std::min(1.0F, settling_ / water) * (in_channel / water);
    const float before = surface_[cell] + laid;
    const Crept crept = creep(cell, before, creep_ * mask);
    if (crept.top <= base) return base;
    const float cutting =
        mask * rate_ * std::sqrt(std::max(in_channel - heads_, kHeadShare * in_channel)) / (distance * crept.stiffness);
    const float gone = std::max(0.0F, before - crept.top);
    const float fine = ground_.sediment.data()[cell] + laid - gone;
    const float coarse = ground_.rock.data()[cell] + std::min(0.0F, fine);
    if (cutting <= 0.0F) return crept.top;
    return cut_down(crept.top, base, fine, coarse,
                    {cutting * sediment_ease_, cutting * rock_ease_, cutting / hardness});
  }

  /// The implicit step of diffusion between a cell and its four neighbours on land, the others where they are now. What
  /// lies in another part may be at work: it is taken to have moved as far as this cell has.
  Crept creep(int32_t cell, float height, float number) const {
    if (number <= 0.0F) return {height, 1.0F};
    const uint8_t part = drainage_.part_of(cell);
    const float moved = level_[cell] - surface_[cell];
    const int x = cell % width_;
    float sum = 0.0F, count = 0.0F;
    const auto add = [&](bool exists, int32_t other) {
      if (!exists) return;
      const uint8_t its = drainage_.part_of(other);
      const float there = its == part || its == Drainage::kTrunk ? level_[other] : surface_[other] + moved;
      if (there <= sea_) return;
      sum += there - height;
      count += 1.0F;
    };
    add(x > 0, cell - 1);
    add(x < width_ - 1, cell + 1);
    add(cell >= width_, cell - width_);
    add(cell < width_ * (height_ - 1), cell + width_);
    const float stiffness = 1.0F + number * count;
    return {height + number * sum / stiffness, stiffness};
  }

  Ground& ground_;
  const Site& site_;
  const Drainage& drainage_;
  const float* surface_;
  const float* discharge_;
  float* load_;
  float* level_;
  int32_t width_, height_;
  float sea_, rate_, rock_ease_, sediment_ease_, threshold_, heads_, settling_, creep_;
};

}  // namespace

void gather(const Drainage& drainage, const Rivers& rivers, ScalarField& discharge, const RunContext& run) {
  const double cell_m = discharge.cell_m();
  std::fill(discharge.cells().begin(), discharge.cells().end(), static_cast<float>(rivers.rain_m * cell_m * cell_m));
  const auto loss_per_m = static_cast<float>(rivers.loss_per_km * 1e-3);
  flow_down(drainage, discharge.data(), run, [&](int32_t cell, size_t, const auto& add) {
    if (drainage.is_root(cell)) return;
    add(std::max(0.0F, 1.0F - loss_per_m * drainage.distance(cell)) * discharge.data()[cell]);
  });
}

void run_rivers(Ground& ground, const Site& site, const Drainage& drainage, const ScalarField& discharge,
                const Rivers& rivers, ScalarField& load, ScalarField& level, Ledger& ledger, const RunContext& run) {
  Step step(ground, site, drainage, discharge, rivers, load, level);
  std::fill(load.cells().begin(), load.cells().end(), 0.0F);
  for (size_t i = 0; i < level.size(); ++i)
    level.data()[i] = ground.surface.data()[i] - site.rise(i, static_cast<float>(rivers.uplift_m));
  for (int sweep = 0; sweep < rivers.sweeps && (rivers.deposition > 0 || rivers.creep_m2 > 0); ++sweep) {
    step.solve(run);
    step.carry<false>(ledger, run);
  }
  step.solve(run);
  limit_slopes(level, drainage, site, rivers.steepest, run);
  step.carry<true>(ledger, run);
}

}  // namespace seamount::erosion
