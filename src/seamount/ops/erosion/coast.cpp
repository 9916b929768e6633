#include "seamount/ops/erosion/coast.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/water/flow.h"
#include "seamount/ops/erosion/beds.h"

namespace seamount::erosion {
namespace {

constexpr double kFetch_m = 400.0;      // size of the bays that shelter
constexpr float kPlatform_m = 1.0F;     // depth at which a cliff's foot is planed
constexpr float kPlaning = 0.2F;        // wear of the floor at the shore over retreat of cliffs
constexpr float kMostPlaned = 0.25F;    // of the way to the waves' base, per step
constexpr float kSettledAtOnce = 0.5F;  // of the water's depth, per step
constexpr float kStirred_m = 1.0F;      // depth that counts for a shoal in which sediment still settles
constexpr float kShoal_m = 0.1F;        // by which what settles may rise over the sea
constexpr float kProfile = 0.1F;        // depth of a shore of fine sand at 1 m from it, growing by the power 2/3
constexpr float kMinReach = 1e-3F;      // share of calm water around a place that can take a load
constexpr double kNear = 0.1;           // of settling_m: where the coarser part of a load settles
constexpr float kNearShare = 0.3F;

/// Exposure to waves in [0, 1] from the share of sea nearby: a straight coast is 1/2.
float exposure_of(float open_sea) { return std::clamp(2.0F * open_sea - 0.5F, 0.0F, 1.0F); }

/// Share of sea around each cell.
void find_open_sea(const Layers& ground, const Sea& sea, ScalarField& open, const RunContext& run) {
  for (size_t i = 0; i < open.size(); ++i) open.data()[i] = sea.covers(i, ground.surface.data()[i]) ? 1.0F : 0.0F;
  geom::gaussian_blur(open, kFetch_m, run);
}

/// Depth that waves keep free of sediment: Dean's profile, 0 where the coast is sheltered. `open` becomes it.
void find_kept_depth(const Layers& ground, const Sea& sea, ScalarField& open, const RunContext& run) {
  Grid<uint8_t> land(ground.frame(), 0);
  for (size_t i = 0; i < land.size(); ++i) land.data()[i] = sea.covers(i, ground.surface.data()[i]) ? 0 : 1;
  const ScalarField from_shore = geom::distance_to(land, run);
  parallel_rows(run, open.width(), open.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < open.width(); ++x) {
        const float exposure = exposure_of(open(x, y)), metres = from_shore(x, y);
        open(x, y) = exposure > 0.0F ? exposure * (kProfile * std::cbrt(metres * metres)) : 0.0F;
      }
    }
  });
}

/// A cell of land that waves reach, the sea cell before it, and the height of the land there.
struct Shore {
  size_t land, water;
  float cliff;
};

std::vector<Shore> find_shore(const HeightField& z, const Sea& sea) {
  std::vector<Shore> shore;
  for (int y = 0; y < z.height(); ++y) {
    for (int x = 0; x < z.width(); ++x) {
      if (z(x, y) < sea.level_m) continue;
      float deepest = sea.level_m, highest = z(x, y);
      size_t water = 0;
      for (int d = 0; d < 8; ++d) {
        const int nx = x + geom::kFlowDx[d], ny = y + geom::kFlowDy[d];
        if (!z.contains(nx, ny)) continue;
        highest = std::max(highest, z(nx, ny));
        const size_t other = static_cast<size_t>(ny) * z.width() + nx;
        if (z(nx, ny) >= deepest || !sea.covers(other, z(nx, ny))) continue;
        deepest = z(nx, ny);
        water = other;
      }
      if (deepest < sea.level_m)
        shore.push_back({static_cast<size_t>(y) * z.width() + x, water, highest - sea.level_m + kPlatform_m});
    }
  }
  return shore;
}

/// Cliffs go back, shoals go down; `load` takes what the waves pick up.
void cut(Layers& ground, const Maps& site, const Coast& coast, const ScalarField& open, ScalarField& load,
         Ledger& ledger) {
  const float sea = coast.sea.level_m;
  const auto retreat = static_cast<float>(coast.retreat_m_yr * coast.years);
  const auto across = static_cast<float>(retreat / ground.surface.cell_m());
  const auto wave_base = static_cast<float>(coast.wave_base_m);
  double eroded = 0;
  const auto pick_up = [&](size_t cell, float depth, size_t water) {
    ground.lower(cell, depth);
    load.data()[water] += depth;
    eroded += depth;
  };
  const auto attack = [&](size_t cell) {
    const float loose = ground.debris.data()[cell] + ground.sediment.data()[cell] > 0.5F ? 2.0F : 1.0F;
    return exposure_of(open.data()[cell]) * value_or_one(site.mask, cell) * loose /
           bedrock_hardness(ground, site, cell);
  };
  const std::vector<Shore> shore = find_shore(ground.surface, coast.sea);
  for (size_t i = 0; i < ground.surface.size(); ++i) {
    const float depth = coast.sea.depth(i, ground.surface.data()[i]);
    if (depth <= 0.0F || depth >= wave_base) continue;
    const float reach = 1.0F - depth / wave_base;
    const float wanted = kPlaning * retreat * attack(i) * reach * reach;
    pick_up(i, std::min(wanted, kMostPlaned * (wave_base - depth)), i);
  }
  for (const Shore& at : shore) {
    const float height = ground.surface.data()[at.land] - sea + kPlatform_m;
    pick_up(at.land, std::min(height, across * attack(at.land) * at.cliff), at.water);
  }
  ledger.eroded += eroded * ground.surface.cell_m() * ground.surface.cell_m();
}

float kept_at(const ScalarField& kept, size_t cell) { return kept.empty() ? 0.0F : kept.data()[cell]; }

/// How willingly a load settles on a cell: not on land, little where waves stir the water, not where they keep it free.
float calm_of(const Layers& ground, const Maps& site, const Coast& coast, const ScalarField& kept, size_t cell) {
  const float depth = coast.sea.depth(cell, ground.surface.data()[cell]);
  if (depth <= kept_at(kept, cell)) return 0.0F;
  return value_or_one(site.mask, cell) *
         std::min(1.0F, (depth + kStirred_m) / (static_cast<float>(coast.wave_base_m) + kStirred_m));
}

/// Spreads `share` of the load over `sigma_m` and lays down what finds room below the depth that waves keep free, if
/// there is one; the rest stays in the load where it is. With a(x) how willingly a place takes it and G the blur, a
/// G(load / G(a)) has the same sum as the load.
double settle(Layers& ground, const Maps& site, const Coast& coast, double sigma_m, float share,
              const ScalarField& kept, ScalarField& load, ScalarField& room, const RunContext& run) {
  for (size_t i = 0; i < room.size(); ++i) room.data()[i] = calm_of(ground, site, coast, kept, i);
  geom::gaussian_blur(room, sigma_m, run);
  for (size_t i = 0; i < room.size(); ++i) {
    float& reach = room.data()[i];
    const float spread = reach > kMinReach ? share * load.data()[i] : 0.0F;
    load.data()[i] -= spread;
    reach = spread > 0.0F ? spread / reach : 0.0F;
  }
  geom::gaussian_blur(room, sigma_m, run);
  double settled = 0;
  for (size_t i = 0; i < room.size(); ++i) {
    const float arrived = calm_of(ground, site, coast, kept, i) * std::max(0.0F, room.data()[i]);
    if (arrived <= 0.0F) continue;
    const float depth = coast.sea.depth(i, ground.surface.data()[i]);
    const float laid = std::min(arrived, kSettledAtOnce * (depth - kept_at(kept, i) + kShoal_m));
    ground.bury(i, laid);
    load.data()[i] += arrived - laid;
    settled += laid;
  }
  return settled;
}

/// What is left settles everywhere by the depth that there is room; what finds none is carried away.
void settle_rest(Layers& ground, const Maps& site, const Coast& coast, const ScalarField& kept, double left,
                 Ledger& ledger) {
  const auto room = [&](size_t i) {
    const float depth = coast.sea.depth(i, ground.surface.data()[i]) - kept_at(kept, i);
    return std::max(0.0F, depth) * value_or_one(site.mask, i);
  };
  double total = 0;
  for (size_t i = 0; i < ground.surface.size(); ++i) total += room(i);
  const auto share = static_cast<float>(total > 0 ? std::min<double>(kSettledAtOnce, left / total) : 0.0);
  double settled = 0;
  for (size_t i = 0; i < ground.surface.size() && share > 0.0F; ++i) {
    const float depth = share * room(i);
    ground.bury(i, depth);
    settled += depth;
  }
  const double area = ground.surface.cell_m() * ground.surface.cell_m();
  ledger.deposited += settled * area;
  ledger.exported += (left - settled) * area;
}

}  // namespace

void run_coast(Layers& ground, const Maps& site, const Coast& coast, ScalarField& load, ScalarField& room,
               Ledger& ledger, const RunContext& run) {
  run.check_cancelled();
  if (*std::min_element(ground.surface.cells().begin(), ground.surface.cells().end()) >= coast.sea.level_m) return;
  if (coast.retreat_m_yr > 0) {
    find_open_sea(ground, coast.sea, room, run);
    cut(ground, site, coast, room, load, ledger);
  }
  double brought = 0, settled = 0;
  for (const float here : load.cells()) brought += here;
  if (brought <= 0) return;
  if (coast.retreat_m_yr <= 0) find_open_sea(ground, coast.sea, room, run);
  ScalarField kept = room;
  find_kept_depth(ground, coast.sea, kept, run);
  settled += settle(ground, site, coast, kNear * coast.settling_m, kNearShare, {}, load, room, run);
  settled += settle(ground, site, coast, coast.settling_m, 1.0F, kept, load, room, run);
  settled += settle(ground, site, coast, coast.settling_m, 1.0F, kept, load, room, run);
  ledger.deposited += settled * ground.surface.cell_m() * ground.surface.cell_m();
  settle_rest(ground, site, coast, kept, brought - settled, ledger);
}

}  // namespace seamount::erosion
