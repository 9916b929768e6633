#include "seamount/ops/erosion/rivers.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/ops/erosion/repose.h"
#include "seamount/ops/erosion/undermining.h"

namespace seamount::erosion {
namespace {

/// What the ground of a cell stands above its channel, for each doubling of the cell, in units of the rate of erosion
/// over K: by how much the mean height of a range in equilibrium grows when its cells are halved.
constexpr double kHiddenPerDoubling = 0.6;
/// Mean height of slopes between channels as far apart as a cell is wide, over that width and their slope.
constexpr double kHiddenShare = 0.25;
/// Creep quickens near the steepest slope (Roering, Kirchner and Dietrich 1999), up to the inverse of this.
constexpr float kLeastEase = 0.1F;
/// Area from which on debris that water gathers cuts hollows into steep slopes.
constexpr double kHollow_m2 = 1000;
/// How far a river builds its bed above both of its banks in a step, in cells.
constexpr float kLevee = 0.25F;
/// Slope above which a river builds no fan, and the slope of a bank that keeps it from spreading.
constexpr float kSteepestFan = 0.1F, kBank = 0.05F;
/// K dt sqrt(Q) / dx that is none: layers of very soft ground would divide by it.
constexpr float kMinRate = 1e-20F;

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

/// What the ground of a cell stands above its channel, in units of the rate of erosion over K sqrt(runoff): the valleys
/// and the slopes that the cell is too wide to show. Valleys are at least `narrowest` apart: channels begin at
/// channel_m2, and creep fills what is narrower than sqrt(D / K) (Perron et al. 2009); slopes between them are
/// parabolas of creep. None where there is no creep, since there are valleys of all sizes.
double hidden_of(const Rivers& rivers, double cell_m) {
  const double per_area = rivers.erodibility * std::sqrt(rivers.runoff_m_yr);
  if (rivers.creep_m2_yr <= 0 || per_area <= 0) return 0.0;
  const double narrowest = std::sqrt(std::max(rivers.channel_m2, rivers.creep_m2_yr / per_area));
  const double doublings = std::max(0.0, std::log2(cell_m / narrowest));
  const double slopes = narrowest * narrowest * per_area / (12.0 * rivers.creep_m2_yr);
  return kHiddenPerDoubling * doublings + std::min(1.0, doublings) * slopes;
}

/// Area above which a cell has a channel. On a plane slope a narrow cell drains a strip, and what makes a channel is
/// how long it is.
double unchannelled_m2(const Rivers& rivers, double cell_m) {
  const double length = std::sqrt(rivers.channel_m2);
  return length * std::min(length, cell_m);
}

double area_of(const Layers& ground) { return ground.surface.cell_m() * ground.surface.cell_m(); }

/// How fast a layer goes down towards the base level, times the step: K dt sqrt(Q) / dx.
struct Rates {
  float sediment, debris, bedrock;
};

/// Height after a step of dh/dt = -F (h - base), F by layer: backward Euler, in which every layer wears at the slope
/// that the step ends with, so that a metre of it counts as F_below / F metres of the layer below. `top` > base.
float cut_down(float top, float base, float sediment, float debris, const Rates& rates, const Beds* beds,
               int32_t cell) {
  float bottom = top, worn = 0.0F;  // how long the layers above took, times the slope at the end
  for (const auto& [thickness, rate] : {std::pair{sediment, rates.sediment}, {debris, rates.debris}}) {
    if (thickness <= 0.0F) continue;
    const float reached = (bottom + rate * (base + worn)) / (1.0F + rate);
    bottom -= thickness;
    if (reached >= bottom) return reached;
    worn += thickness / rate;
  }
  if (beds != nullptr) return beds->cut(static_cast<size_t>(cell), bottom, base, worn, rates.bedrock);
  return (bottom + rates.bedrock * (base + worn)) / (1.0F + rates.bedrock);
}

/// Ground that creep has moved, before rivers cut it: where its top is, and how much it resists going anywhere else.
struct Crept {
  float top;
  float stiffness;  ///< 1 + D dt (neighbours) / dx^2
};

/// Heights around a cell, added up by how readily creep passes between them and the cell.
struct Around {
  float sum = 0, count = 0;
};

/// What a sweep downstream is for: a first guess of the load, where the ground has come to lie without any; the load of
/// the next sweep; or to move the ground.
enum class Carry { guess, tell, move };

/// The sweeps of one step over one ground.
class Step {
 public:
  Step(Layers& ground, const Maps& site, const Drainage& drainage, const ScalarField& discharge, const Rivers& rivers,
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
        debris_ease_(static_cast<float>(rivers.debris_ease)),
        sediment_ease_(static_cast<float>(rivers.sediment_ease)),
        threshold_(static_cast<float>(rivers.runoff_m_yr * unchannelled_m2(rivers, ground.surface.cell_m()))),
        hidden_(static_cast<float>(hidden_of(rivers, ground.surface.cell_m()) / std::sqrt(rivers.runoff_m_yr))),
        most_hidden_(static_cast<float>(kHiddenShare * rivers.steepest * ground.surface.cell_m())),
        settling_(static_cast<float>(rivers.deposition * rivers.runoff_m_yr * area_of(ground))),
        fan_(static_cast<float>(rivers.fan_m)),
        creep_(static_cast<float>(rivers.creep_m2_yr * rivers.years / area_of(ground))),
        rivers_win_(static_cast<float>(
            rivers.creep_m2_yr > 0 ? rivers.erodibility / (std::sqrt(rivers.runoff_m_yr) * rivers.creep_m2_yr) : 1e9)),
        // Beds stand as steep as they can without creeping.
        per_steepest_(site.beds != nullptr ? 0.0F
                                           : static_cast<float>(1.0 / (rivers.steepest * ground.surface.cell_m()))),
        trust_(static_cast<float>(1.0 / (1.0 + 0.5 * rivers.deposition))),
        undermining_(site, drainage, rivers.steepest) {}

  /// Where each cell would come to lie, from the outlets up, given the load. Below a lake's level: that level.
  void solve(const RunContext& run) {
    const auto all = [&](std::span<const int32_t> cells) {
      for (const int32_t cell : cells)
        level_[cell] = drainage_.is_root(cell) ? std::max(surface_[cell], sea_) : level_of(cell);
    };
    all(drainage_.trunk());
    for_parts(drainage_, run, [&](size_t part) { all(drainage_.part(part)); });
  }

  /// The load of the next sweep: where the ground has come to lie without any load, a first guess, and later so far
  /// from the last one that sweeps do not swing.
  void tell(bool first, const RunContext& run) {
    Ledger none;
    if (first) return carry<Carry::guess>(none, run);
    const std::vector<float> last(load_, load_ + drainage_.order().size());
    carry<Carry::tell>(none, run);
    for (size_t i = 0; i < last.size(); ++i) load_[i] = last[i] + trust_ * (load_[i] - last[i]);
  }

  /// Carries the load downstream.
  template <Carry what>
  void carry(Ledger& ledger, const RunContext& run) {
    constexpr bool moving = what == Carry::move;
    std::fill_n(load_, drainage_.order().size(), 0.0F);
    std::vector<Ledger> ledgers(drainage_.parts() + 1);
    flow_down(drainage_, load_, run, [&](int32_t cell, size_t part, const auto& add) {
      if (drainage_.is_root(cell)) {
        if (moving) level_[cell] = 0.0F, leave(cell, ledgers[part]);
      } else {
        add(pass_on<what>(cell, ledgers[part]));
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
  template <Carry what>
  float pass_on(int32_t cell, Ledger& ledger) {
    constexpr bool moving = what == Carry::move;
    float change = level_[cell] - surface_[cell];
    if (!moving && change < 0.0F) {  // what fails is no load that rivers drop on their way, with beds or without
      const float top = surface_[cell], stands = undermining_.standing(cell, level_[drainage_.receiver(cell)], top);
      change = std::min(0.0F, change + (top - stands));
    }
    float leaving = load_[cell];
    if (moving) level_[cell] = 0.0F;
    if (what == Carry::guess) leaving -= leaving * settling_share(cell) / (1.0F + cutting(cell) * sediment_ease_);
    if (change < 0.0F) {
      leaving -= change;
      if (moving) ground_.lower(cell, -change);
      ledger.eroded -= change;
    } else if (value_or_one(site_.mask, cell) > 0.0F) {
      const float laid = std::min(change, leaving);
      leaving -= laid;
      if (moving) {
        ground_.bury(cell, laid);
        level_[cell] = laid;
      }
      ledger.deposited += laid;
    }
    if (moving) load_[cell] = 0.0F;
    return leaving;
  }

  /// Water that cuts and lays down, and what of a cell's discharge it is.
  float in_channel(int32_t cell) const { return discharge_[cell] > threshold_ ? discharge_[cell] : 0.0F; }

  /// What a river lays down of the load that comes to a cell.
  float settling_share(int32_t cell) const {
    const float water = discharge_[cell];
    return value_or_one(site_.mask, cell) * std::min(1.0F, settling_ * fan_width(cell) / water) *
           (in_channel(cell) / water);
  }

  /// Over how many cells side by side a river lays down its load in the years of a step: one between banks or on steep
  /// ground, and as many as its fan is wide where it runs free.
  float fan_width(int32_t cell) const {
    if (fan_ <= 0.0F) return 1.0F;
    const float distance = drainage_.distance(cell);
    const float slope = (surface_[cell] - surface_[drainage_.receiver(cell)]) / distance;
    const float gentle = 1.0F - slope / kSteepestFan;
    const int x = cell % width_;
    if (gentle <= 0.0F || x == 0 || x == width_ - 1 || cell < width_ || cell >= width_ * (height_ - 1)) return 1.0F;
    const float bank =
        std::min(surface_[drainage_.beside(cell, 2)], surface_[drainage_.beside(cell, 6)]) - surface_[cell];
    const float open = std::clamp(1.0F - bank / (kBank * distance), 0.0F, 1.0F);
    return 1.0F + std::min(1.0F, gentle) * open * fan_ / distance;
  }

  /// K dt sqrt(Q) / dx for bedrock of hardness 1. `hidden`: what a cell stands over its channel, as hidden_of.
  float cutting(int32_t cell, float hidden = 0.0F) const {
    const float root = std::sqrt(in_channel(cell));
    return value_or_one(site_.mask, cell) * rate_ * root / (drainage_.distance(cell) + hidden * root);
  }

  /// How much of what a cell hides stands over its receiver's ground: all of it over an outlet or land that does not
  /// rise.
  float steps_up(int32_t cell) const {
    const int32_t receiver = drainage_.receiver(cell);
    if (drainage_.is_root(receiver)) return 1.0F;
    if (site_.uplift.empty()) return 0.0F;
    const float own = site_.uplift.data()[cell];
    return own > 0.0F ? std::max(0.0F, 1.0F - site_.uplift.data()[receiver] / own) : 0.0F;
  }

  /// What creeps into a river goes with it: there creep counts only where it takes away. But it fills hollows that are
  /// too small for rivers to keep open: K A / D below 1 (Perron et al. 2009).
  float level_of(int32_t cell) {
    const float base = level_[drainage_.receiver(cell)];
    const float laid = load_[cell] * settling_share(cell);
    const float before = surface_[cell] + laid, number = creep_ * value_or_one(site_.mask, cell);
    const Around around = number > 0.0F ? around_of(cell) : Around{};
    const float highest = std::max(base, surface_[cell] + room_below_banks(cell));
    if (around.count == 0.0F) return worn_down(cell, base, laid, {before, 1.0F}, highest);
    const float stiffness = 1.0F + number * around.count;
    const float top = before + number * (around.sum - around.count * before) / stiffness;
    const float crept = worn_down(cell, base, laid, {top, stiffness}, highest);
    if (cutting(cell) <= kMinRate) return crept;
    const float kept = worn_down(cell, base, laid, {before, 1.0F}, highest);
    if (around.sum <= around.count * kept) return crept;
    const float wins = rivers_win_ * discharge_[cell], share = wins * wins / (1.0F + wins * wins);
    return crept + share * (kept - crept);
  }

  /// Height of a cell with `laid` metres of new sediment after creep, if rivers cut it for the years of a step.
  float worn_down(int32_t cell, float base, float laid, const Crept& crept, float highest) {
    if (crept.top <= base) return base;
    const float stands = undermining_.standing(cell, base, crept.top);
    float rate = cutting(cell) / crept.stiffness;
    if (rate < kMinRate) return std::min(stands, highest);
    const float gone = std::max(0.0F, surface_[cell] + laid - stands);
    const float fine = ground_.sediment.data()[cell] + laid - gone;
    const float coarse = ground_.debris.data()[cell] + std::min(0.0F, fine);
    rate = std::max(kMinRate, rate * undermining_.time_left(cell, stands, crept.top, rate));
    const auto reached = [&](float by) {
      const Rates rates{by * sediment_ease_, by * debris_ease_, by / value_or_one(site_.hardness, cell)};
      return cut_down(stands, base, fine, coarse, rates, site_.beds, cell);
    };
    float level = reached(rate);
    // Land begins as high over its outlets as its cells stand over their channels.
    if (const float share = hidden_ > 0.0F ? steps_up(cell) : 0.0F; share > 0.0F)
      level = std::min(reached(cutting(cell, share * hidden_) / crept.stiffness), level + share * most_hidden_);
    return std::min(level, highest);
  }

  /// How far a bed may rise: up to its banks and a little, then the river breaks out.
  float room_below_banks(int32_t cell) const {
    const float levee = kLevee * drainage_.distance(cell);
    const int x = cell % width_;
    if (x == 0 || x == width_ - 1 || cell < width_ || cell >= width_ * (height_ - 1)) return levee;
    const float bank = std::max(surface_[drainage_.beside(cell, 2)], surface_[drainage_.beside(cell, 6)]);
    return levee + std::max(0.0F, bank - surface_[cell]);
  }

  /// The four neighbours on land as they come to lie. What lies in another part may be at work: it is taken to have
  /// moved as far as this cell has.
  Around around_of(int32_t cell) const {
    const uint8_t part = drainage_.part_of(cell);
    const float moved = level_[cell] - surface_[cell];
    const int x = cell % width_;
    Around around;
    const auto add = [&](bool exists, int32_t other) {
      if (!exists) return;
      const uint8_t its = drainage_.part_of(other);
      const float there = its == part || its == Drainage::kTrunk ? level_[other] : surface_[other] + moved;
      if (there <= sea_ && drainage_.is_root(other)) return;
      const float steep = (surface_[other] - surface_[cell]) * per_steepest_;
      const float eased = 1.0F / std::max(kLeastEase, 1.0F - steep * steep);
      around.sum += eased * there;
      around.count += eased;
    };
    add(x > 0, cell - 1);
    add(x < width_ - 1, cell + 1);
    add(cell >= width_, cell - width_);
    add(cell < width_ * (height_ - 1), cell + width_);
    return around;
  }

  Layers& ground_;
  const Maps& site_;
  const Drainage& drainage_;
  const float* surface_;
  const float* discharge_;
  float* load_;
  float* level_;
  int32_t width_, height_;
  float sea_, rate_, debris_ease_, sediment_ease_, threshold_, hidden_, most_hidden_, settling_, fan_, creep_,
      rivers_win_, per_steepest_, trust_;
  Undermining undermining_;
};

}  // namespace

void gather(const Drainage& drainage, const Maps& site, const Rivers& rivers, ScalarField& discharge,
            const RunContext& run) {
  const auto rain = static_cast<float>(rivers.runoff_m_yr * discharge.cell_m() * discharge.cell_m());
  for (size_t i = 0; i < discharge.size(); ++i) discharge.data()[i] = rain * value_or_one(site.rain, i);
  const auto loss_per_m = static_cast<float>(rivers.loss_per_km * 1e-3);
  flow_down(drainage, discharge.data(), run, [&](int32_t cell, size_t, const auto& add) {
    if (drainage.is_root(cell)) return;
    add(std::max(0.0F, 1.0F - loss_per_m * drainage.distance(cell)) * discharge.data()[cell]);
  });
}

void run_rivers(Layers& ground, const Maps& site, const Drainage& drainage, const ScalarField& discharge,
                const Rivers& rivers, ScalarField& load, ScalarField& level, Ledger& ledger, const RunContext& run) {
  Step step(ground, site, drainage, discharge, rivers, load, level);
  std::fill(load.cells().begin(), load.cells().end(), 0.0F);
  for (size_t i = 0; i < level.size(); ++i)
    level.data()[i] = ground.surface.data()[i] - site.rise(i, static_cast<float>(rivers.uplift_m));
  const int sweeps = rivers.deposition > 0 || rivers.creep_m2_yr > 0 ? rivers.sweeps : 0;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    step.solve(run);
    if (rivers.deposition > 0) step.tell(sweep == 0, run);
  }
  step.solve(run);
  find_steepest_rise(discharge, site,
                     {rivers.steepest, rivers.hardness_variation, rivers.runoff_m_yr * kHollow_m2, rivers.rock}, load,
                     run);
  limit_slopes(level, drainage, site, load, run);
  step.carry<Carry::move>(ledger, run);
}

}  // namespace seamount::erosion
