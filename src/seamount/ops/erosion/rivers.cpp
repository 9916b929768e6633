#include "seamount/ops/erosion/rivers.h"

#include <algorithm>
#include <cmath>

namespace seamount::erosion {
namespace {

constexpr size_t kCancelEvery = 1 << 16;
/// Rivers of a few cells cut less than their discharge says: a coarse cell is mostly slope, and without this erosion
/// would grow with the size of the cells. What flows off this many cells does not cut, but for the share below.
constexpr double kHeadCells = 2.0;
constexpr float kHeadShare = 0.03F;

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

/// The sweeps of one step over one ground.
class Step {
 public:
  Step(Ground& ground, const Site& site, const Drainage& drainage, const ScalarField& discharge, const Rivers& rivers,
       ScalarField& load, ScalarField& level)
      : ground_(ground),
        site_(site),
        drainage_(drainage),
        discharge_(discharge.data()),
        load_(load.data()),
        level_(level.data()),
        sea_(static_cast<float>(rivers.sea_m)),
        rate_(static_cast<float>(rivers.erodibility * rivers.years)),
        rock_ease_(static_cast<float>(rivers.rock_ease)),
        sediment_ease_(static_cast<float>(rivers.sediment_ease)),
        threshold_(static_cast<float>(rivers.rain_m * rivers.channel_m2)),
        heads_(static_cast<float>(rivers.rain_m * kHeadCells * area_of(ground))),
        settling_(static_cast<float>(rivers.deposition * rivers.rain_m * area_of(ground))) {}

  /// Where each cell would come to lie, from the outlets up, given the load. Below a lake's level: that level.
  void solve(const RunContext& run) {
    const auto order = drainage_.order();
    const float* surface = ground_.surface.data();
    for (size_t k = 0; k < order.size(); ++k) {
      if (k % kCancelEvery == 0) run.check_cancelled();
      const int32_t cell = order[k];
      const float height = surface[cell];
      if (drainage_.is_root(cell)) {
        level_[cell] = std::max(height, sea_);
        continue;
      }
      const float base = level_[drainage_.receiver(cell)];
      const float mask = value_or_one(site_.mask, cell);
      const float water = discharge_[cell];
      const float laid = mask * load_[cell] * std::min(1.0F, settling_ / water);
      const float top = height + laid;
      if (top <= base) {
        level_[cell] = base;
        continue;
      }
      const float in_channel = std::max(0.0F, water - threshold_);
      const float cutting =
          mask * rate_ * std::sqrt(std::max(in_channel - heads_, kHeadShare * in_channel)) / drainage_.distance(cell);
      const Rates rates{cutting * sediment_ease_, cutting * rock_ease_, cutting / value_or_one(site_.hardness, cell)};
      level_[cell] = cutting <= 0.0F
                         ? top
                         : cut_down(top, base, ground_.sediment.data()[cell] + laid, ground_.rock.data()[cell], rates);
    }
  }

  /// Carries the load downstream. `moving`: changes the ground; else only tells the load of the next sweep.
  template <bool moving>
  void carry(Ledger& ledger, const RunContext& run) {
    const auto order = drainage_.order();
    std::fill(load_, load_ + order.size(), 0.0F);
    double eroded = 0, deposited = 0;
    for (size_t k = order.size(); k-- > 0;) {
      if (k % kCancelEvery == 0) run.check_cancelled();
      const int32_t cell = order[k];
      if (drainage_.is_root(cell)) continue;
      const float change = level_[cell] - ground_.surface.data()[cell];
      float leaving = load_[cell];
      if (change < 0.0F) {
        leaving -= change;
        if (moving) ground_.lower(cell, -change);
        eroded -= change;
      } else if (value_or_one(site_.mask, cell) > 0.0F) {
        const float laid = std::min(change, leaving);
        leaving -= laid;
        if (moving) ground_.bury(cell, laid);
        deposited += laid;
      }
      load_[drainage_.receiver(cell)] += leaving;
      if (moving) load_[cell] = 0.0F;
    }
    if (!moving) return;
    const double area = area_of(ground_);
    ledger.eroded += eroded * area;
    ledger.deposited += deposited * area;
    for (const int32_t cell : order) {
      if (!drainage_.is_root(cell) || ground_.surface.data()[cell] < sea_) continue;
      ledger.exported += static_cast<double>(load_[cell]) * area;
      load_[cell] = 0.0F;
    }
  }

 private:
  Ground& ground_;
  const Site& site_;
  const Drainage& drainage_;
  const float* discharge_;
  float* load_;
  float* level_;
  float sea_, rate_, rock_ease_, sediment_ease_, threshold_, heads_, settling_;
};

}  // namespace

void gather(const Drainage& drainage, const Rivers& rivers, ScalarField& discharge, const RunContext& run) {
  const double cell_m = discharge.cell_m();
  std::fill(discharge.cells().begin(), discharge.cells().end(), static_cast<float>(rivers.rain_m * cell_m * cell_m));
  const auto order = drainage.order();
  const auto loss_per_m = static_cast<float>(rivers.loss_per_km * 1e-3);
  for (size_t k = order.size(); k-- > 0;) {
    if (k % kCancelEvery == 0) run.check_cancelled();
    const int32_t cell = order[k];
    if (drainage.is_root(cell)) continue;
    const float kept = std::max(0.0F, 1.0F - loss_per_m * drainage.distance(cell));
    discharge.data()[drainage.receiver(cell)] += kept * discharge.data()[cell];
  }
}

void run_rivers(Ground& ground, const Site& site, const Drainage& drainage, const ScalarField& discharge,
                const Rivers& rivers, ScalarField& load, ScalarField& level, Ledger& ledger, const RunContext& run) {
  Step step(ground, site, drainage, discharge, rivers, load, level);
  std::fill(load.cells().begin(), load.cells().end(), 0.0F);
  for (int sweep = 0; sweep < rivers.sweeps && rivers.deposition > 0; ++sweep) {
    step.solve(run);
    step.carry<false>(ledger, run);
  }
  step.solve(run);
  step.carry<true>(ledger, run);
}

}  // namespace seamount::erosion
