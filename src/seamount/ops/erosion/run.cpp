#include "seamount/ops/erosion/run.h"

#include <algorithm>
#include <cmath>

#include <numbers>
#include <optional>

#include "seamount/base/parallel.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/same_size.h"
#include "seamount/ops/erosion/beds.h"
#include "seamount/ops/erosion/coast.h"
#include "seamount/ops/erosion/drainage.h"
#include "seamount/ops/erosion/fade.h"
#include "seamount/ops/erosion/fans.h"
#include "seamount/ops/erosion/hardness.h"
#include "seamount/ops/erosion/hollows.h"
#include "seamount/ops/erosion/levels.h"
#include "seamount/ops/erosion/margin.h"
#include "seamount/ops/erosion/rivers.h"
#include "seamount/ops/erosion/slopes.h"

namespace seamount::erosion {
namespace {

constexpr int kCoarsestSide = 64;     // grids are halved until the next one would be smaller
constexpr double kShareOfRest = 0.3;  // of the remaining years that a coarse grid takes
constexpr int kMostSteps = 24, kFewestSteps = 6;
constexpr int kSlides = 2;                  // rounds per step
constexpr double kOutletReach = 1.0 / 16;   // of the map's side along which valleys compete for an outlet
constexpr double kMargin = 1.0 / 24;        // of the map's side: land beyond the border
constexpr double kMarginOfRise = 1.0 / 64;  // the same, if the land rises up to its border

/// How a grid spends its share of the years.
struct Stage {
  double years = 0;
  int steps = 0;
};

/// Steps on a grid.
int steps_for(const GridFrame& frame) {
  return std::clamp(kMostSteps * 256 / std::max(frame.width, frame.height), kFewestSteps, kMostSteps);
}

void check_map(const ScalarField& map, const GridFrame& frame, const char* name) {
  if (!map.empty()) check_same_size(name, map.frame(), frame);
}

void limit(ScalarField& map, float low, float high) {
  for (float& value : map.cells()) value = std::clamp(value, low, high);
}

/// A share lies from 0 to 1; what does not is said.
void limit_mask(Mask& mask, const RunContext& run) {
  const auto outside = [](float share) { return !(share >= 0.0F && share <= 1.0F); };
  const auto count = std::count_if(mask.cells().begin(), mask.cells().end(), outside);
  if (count > 0)
    run.say("mask: values outside of 0 to 1 (" + std::to_string(count) + " cells) are taken for the nearer of the two");
  limit(mask, 0.0F, 1.0F);
}

Rivers rivers_of(const RunParams& p, double years, Seed rock) {
  const bool carries = p.method == Method::hydraulic;
  return {.years = years,
          .runoff_m_yr = p.runoff_mm_yr / 1000.0,
          .loss_per_km = p.rivers.evaporation_per_km,
          .erodibility = p.erodibility,
          .debris_ease = carries ? p.rivers.debris_ease : 1.0,
          .sediment_ease = carries ? p.rivers.sediment_ease : 1.0,
          .deposition = carries ? p.rivers.deposition : 0.0,
          .fan_m = p.rivers.fan_m,
          .channel_m2 = p.rivers.channel_m2,
          .creep_m2_yr = p.slopes.creep_m2_yr,
          .steepest = std::tan(p.slopes.bedrock_angle_deg * std::numbers::pi / 180.0),
          .hardness_variation = p.hardness_variation,
          .rock = rock,
          .uplift_m = p.uplift_mm_yr * 1e-3 * years,
          .sea_m = p.sea_m,
          .sweeps = carries ? 2 : 1};
}

/// Bedrock that stands so steep breaks off at once and lies at its foot; what is gentler fails over the years.
double breaking_angle(const RunParams& p) {
  const double rise = std::tan(p.slopes.bedrock_angle_deg * std::numbers::pi / 180.0);
  return std::atan((1.0 + p.hardness_variation) * rise) * 180.0 / std::numbers::pi;
}

Slopes slopes_of(const RunParams& p, double years) {
  return {.years = years,
          .sediment_angle_deg = p.slopes.sediment_angle_deg,
          .debris_angle_deg = p.slopes.debris_angle_deg,
          .bedrock_angle_deg = breaking_angle(p),
          .weathering_m_yr = p.method == Method::hydraulic ? p.slopes.weathering_mm_yr * 1e-3 : 0.0,
          .slides = kSlides};
}

Coast coast_of(const RunParams& p, double years, const Sea& sea) {
  return {.years = years,
          .sea = sea,
          .retreat_m_yr = p.method == Method::hydraulic ? p.coast.retreat_mm_yr * 1e-3 : 0.0,
          .wave_base_m = p.coast.wave_base_m,
          .settling_m = p.coast.settling_m};
}

/// The run on one grid.
class Level {
 public:
  /// `done` years have gone by.
  Level(Layers& ground, Maps& site, const Grid<uint8_t>& outlets, const RunParams& params, const Lithology& beds,
        Seed rock, double done, const RunContext& run)
      : ground_(ground),
        site_(site),
        params_(params),
        rock_(rock),
        outlets_(outlets),
        flow_(ground.frame()),
        load_(ground.frame()),
        room_(ground.frame()),
        done_(done),
        hollows_(geom::find_hollows(ground.surface, static_cast<float>(params.sea_m), std::nullopt, run)) {
    if (!beds.beds().empty()) site.beds = &beds_.emplace(beds, ground.frame(), run);
    for (size_t i = 0; i < outlets.size(); ++i) {
      if (outlets.data()[i] != 0) base_levels_.emplace_back(i, ground.surface.data()[i]);
    }
  }

  double done() const { return done_; }

  void step(double years, Seed seed, Ledger& ledger, const RunContext& run) {
    uplift(years, ledger);
    done_ += years;
    settle_beds(run);
    // First, so that rivers clear away what slides into them.
    run_slopes(ground_, site_, slopes_of(params_, years), load_, room_, run);
    clear_outlets(ledger);
    const Rivers rivers = rivers_of(params_, years, rock_);
    drainage_.route(ground_.surface, outlets_, sea(), seed, room_, run);
    gather(drainage_, site_, rivers, flow_, run);
    run_rivers(ground_, site_, drainage_, flow_, rivers, load_, room_, ledger, run);
    std::swap(flow_, room_);  // what rivers laid down; their discharge is not needed any more
    run_coast(ground_, site_, coast_of(params_, years, sea()), load_, room_, ledger, run);
    if (rivers.deposition > 0) spread_deposits(ground_, flow_, site_, load_, room_, run);
    clear_outlets(ledger);
  }

  /// Discharge, lakes and the last shallow hollows.
  void finish(bool fill_hollows, Ledger& ledger, ScalarField& flow, ScalarField& lake, ScalarField& bed,
              const RunContext& run) {
    drainage_.route(ground_.surface, outlets_, sea(), std::nullopt, room_, run);
    gather(drainage_, site_, rivers_of(params_, 0, rock_), flow_, run);
    run.check_cancelled();
    settle_hollows(ground_, site_, drainage_, static_cast<float>(params_.sea_m), fill_hollows, load_, room_, ledger);
    run.check_cancelled();
    flow = std::move(flow_);
    lake = std::move(load_);
    bed = std::move(room_);
    std::fill(bed.cells().begin(), bed.cells().end(), 0.0F);
    if (!beds_) return;
    settle_beds(run);
    for (size_t i = 0; i < bed.size(); ++i) {
      bed.data()[i] = static_cast<float>(1 + beds_->bed(i, ground_.bedrock(i)));
    }
  }

 private:
  Sea sea() const { return {static_cast<float>(params_.sea_m), &hollows_}; }

  void settle_beds(const RunContext& run) {
    if (beds_) beds_->settle(ground_, site_, static_cast<float>(params_.uplift_mm_yr * 1e-3 * done_), run);
  }

  void uplift(double years, Ledger& ledger) {
    const auto rise = static_cast<float>(params_.uplift_mm_yr * 1e-3 * years);
    if (rise <= 0.0F) return;
    double sum = 0;
    for (size_t i = 0; i < ground_.surface.size(); ++i) {
      if (outlets_.data()[i] != 0) continue;
      const float own = site_.rise(i, rise);
      ground_.surface.data()[i] += own;
      sum += own;
    }
    ledger.uplifted += sum * ground_.surface.cell_m() * ground_.surface.cell_m();
  }

  /// What came to lie on an outlet is carried off the map: it keeps its height.
  void clear_outlets(Ledger& ledger) {
    double sum = 0;
    for (const auto& [cell, height] : base_levels_) {
      const float above = std::max(0.0F, ground_.surface.data()[cell] - height);
      ground_.lower(cell, above);
      sum += above;
    }
    ledger.exported += sum * ground_.surface.cell_m() * ground_.surface.cell_m();
  }

  Layers& ground_;
  const Maps& site_;
  const RunParams& params_;
  Seed rock_;
  const Grid<uint8_t>& outlets_;
  std::vector<std::pair<size_t, float>> base_levels_;
  Drainage drainage_;
  ScalarField flow_, load_, room_;
  double done_;
  std::optional<Beds> beds_;
  Grid<uint8_t> hollows_;
};

/// Grounds and sites from fine to coarse; index 0 is the finest.
struct Pyramid {
  std::vector<Layers> starts;
  std::vector<Maps> sites;
};

Pyramid pyramid_of(Layers ground, Maps site, const RunContext& run) {
  Pyramid levels;
  levels.starts.push_back(std::move(ground));
  levels.sites.push_back(std::move(site));
  while (std::min(levels.starts.back().frame().width, levels.starts.back().frame().height) >= 2 * kCoarsestSide) {
    levels.starts.push_back(halved(levels.starts.back(), run));
    levels.sites.push_back(halved(levels.sites.back(), run));
  }
  return levels;
}

/// Steps become shorter towards the end of a stage, so that its last changes have settled.
double share_of_step(int i, int steps) {
  const double left = steps - i, all = steps;
  return 6.0 * left * left / (all * (all + 1) * (2 * all + 1));
}

/// Stages by level, coarsest last.
std::vector<Stage> plan(const Pyramid& levels, const RunParams& params) {
  std::vector<Stage> stages(levels.starts.size());
  double left = params.years;
  for (size_t k = stages.size(); k-- > 0;) {
    stages[k] = {(k == 0 ? 1.0 : kShareOfRest) * left, left > 0 ? steps_for(levels.starts[k].frame()) : 0};
    left -= stages[k].years;
  }
  return stages;
}

/// Cells of land beyond the border.
int margin_of(const GridFrame& frame, const RunParams& params) {
  if (params.years <= 0) return 0;
  const double share = params.uplift_mm_yr > 0 ? kMarginOfRise : kMargin;
  return static_cast<int>(std::ceil(share * std::max(frame.width, frame.height)));
}

/// Lets land go on beyond the border, where it does not rise.
void extend(Layers& ground, Maps& site, int cells, const RunParams& params, const RunContext& run) {
  if (params.uplift_mm_yr > 0 && site.uplift.empty()) site.uplift = ScalarField(ground.frame(), 1.0F);
  for (ScalarField* map : {&ground.surface, &ground.debris, &ground.sediment, &site.hardness, &site.mask, &site.rain}) {
    *map = extended(*map, cells, std::nullopt, run);
  }
  site.uplift = extended(site.uplift, cells, 0.0F, run);
}

double volume_of(const HeightField& surface) {
  double sum = 0;
  for (const float z : surface.cells()) sum += z;
  return sum * surface.cell_m() * surface.cell_m();
}

/// Takes the margin away again. What left the map is what it lost but for what the run itself did not keep.
void crop(Eroded& out, const GridFrame& frame, int cells, double start_m3, double extended_start_m3) {
  const double run_lost = extended_start_m3 - volume_of(out.terrain);
  for (ScalarField* field : {&out.terrain, &out.debris, &out.sediment, &out.flow, &out.lake, &out.bed})
    *field = cropped(*field, frame, cells);
  out.ledger.exported += start_m3 - volume_of(out.terrain) - run_lost;
}

/// The run on ground and maps that fit.
Eroded run_extended(Layers ground, Maps site, const RunParams& params, Seed seed, const RunContext& run) {
  const GridFrame frame = ground.frame();
  const Mask asked = site.mask;
  const Layers before = asked.empty() ? Layers() : ground;
  site.mask = opened(asked);
  if (params.lithology.beds.empty() && !params.lithology.faults.empty())
    run.say("lithology: faults move nothing without beds");
  const Lithology beds(params.lithology, seed.derive("erosion.beds"));
  Pyramid levels = pyramid_of(std::move(ground), std::move(site), run);
  const std::vector<Stage> stages = plan(levels, params);
  double cost = 0, done = 0, years = 0;
  for (size_t k = 0; k < stages.size(); ++k) cost += static_cast<double>(stages[k].steps) / std::pow(4.0, k);

  const RunContext quiet{run.threads, {}, run.cancelled, {}}, once{run.threads, {}, run.cancelled, run.note};
  Eroded out;
  Layers now = levels.starts.size() > 1 ? levels.starts.back() : std::move(levels.starts.back());
  Grid<uint8_t> outlets = border_outlets(now.surface, kOutletReach * std::max(frame.width_m(), frame.height_m()));
  for (size_t k = stages.size(); k-- > 0;) {
    {
      Level level(now, levels.sites[k], outlets, params, beds, seed.derive("erosion.joints"), years,
                  k == 0 ? once : quiet);
      for (int i = 0; i < stages[k].steps; ++i) {
        level.step(stages[k].years * share_of_step(i, stages[k].steps), seed.derive("erosion.ways", stages.size() - k),
                   out.ledger, quiet);
        done += std::pow(0.25, k);
        run.report(std::min(1.0, done / cost));
      }
      if (k == 0 && !asked.empty())
        keep_share(faded(asked, before.surface, now.surface, run), before, now, out.ledger, run);
      if (k == 0) level.finish(params.years > 0, out.ledger, out.flow, out.lake, out.bed, run);
      years = level.done();
    }
    if (k == 0) break;
    Layers finer = k > 1 ? levels.starts[k - 1] : std::move(levels.starts[0]);
    outlets = refined_outlets(outlets, finer.surface);
    refine(now, levels.starts[k], finer, levels.sites[k - 1], outlets, seed.derive("erosion.bends", stages.size() - k),
           out.ledger, run);
    now = std::move(finer);
    levels.starts.resize(k);
    levels.sites.resize(k);
  }
  out.terrain = std::move(now.surface);
  out.debris = std::move(now.debris);
  out.sediment = std::move(now.sediment);
  return out;
}

}  // namespace

Eroded run(Layers ground, Maps site, const RunParams& params, Seed seed, const RunContext& run) {
  check_params(params);
  const GridFrame frame = ground.frame();
  check_map(ground.debris, frame, "debris");
  check_map(ground.sediment, frame, "sediment");
  check_map(site.hardness, frame, "hardness");
  check_map(site.mask, frame, "mask");
  check_map(site.uplift, frame, "uplift");
  check_map(site.rain, frame, "rain");
  if (ground.debris.empty()) ground.debris = ScalarField(frame, 0.0F);
  if (ground.sediment.empty()) ground.sediment = ScalarField(frame, 0.0F);
  limit(ground.debris, 0.0F, 1e5F);
  limit(ground.sediment, 0.0F, 1e5F);
  settle_hardness(site.hardness, run);
  const double start_m3 = volume_of(ground.surface);
  const int margin = margin_of(frame, params);
  extend(ground, site, margin, params, run);
  vary_hardness(site.hardness, ground.frame(), params.hardness_variation, seed.derive("erosion.rock"), run);
  limit(site.hardness, 0.01F, 1e6F);
  limit_mask(site.mask, run);
  limit(site.uplift, 0.0F, 1e3F);
  limit(site.rain, 1e-3F, 1e3F);  // every cell has some, which others divide by
  run.check_cancelled();

  const double extended_start_m3 = volume_of(ground.surface);
  Eroded out = run_extended(std::move(ground), std::move(site), params, seed, run);
  crop(out, frame, margin, start_m3, extended_start_m3);
  return out;
}

}  // namespace seamount::erosion
