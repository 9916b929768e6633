#include "seamount/ops/glacier/run.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/geom/grid/pyramid.h"
#include "seamount/model/same_size.h"
#include "seamount/ops/glacier/carve.h"
#include "seamount/ops/glacier/ice.h"

namespace seamount::glacier {
namespace {

constexpr int kCoarsestSide = 64;
constexpr double kShareOfRest = 0.35;  // of the remaining years that a coarse grid takes
constexpr int kMostSteps = 24, kFewestSteps = 4;
constexpr double kIceStep_yr = 100;
constexpr int kGathering = 40;            // steps in which ice gathers on the coarsest grid
constexpr int kBetween = 2, kSweeps = 3;  // steps of ice between two of carving, and their sweeps
constexpr int kSettling = 4;              // steps of ice on each grid before and after
constexpr double kGround = 1.0;           // depth of carving, in cells, by which most detail is ground off

int steps_for(const GridFrame& frame) {
  return std::clamp(kMostSteps * 128 / std::max(frame.width, frame.height), kFewestSteps, kMostSteps);
}

/// Ground and ice of a coarse grid on one of twice its size, whose ground before any ice is `start`.
void refine(const HeightField& coarse_start, const HeightField& coarse_bed, const HeightField& coarse_surface,
            const HeightField& start, HeightField& bed, HeightField& surface, const RunContext& run) {
  const GridFrame& frame = start.frame();
  HeightField before = geom::doubled(coarse_start, frame, run);
  bed = geom::doubled(coarse_bed, frame, run);
  surface = geom::doubled(coarse_surface, frame, run);
  const auto per_cell = static_cast<float>(1.0 / (kGround * frame.cell_m));
  for (size_t i = 0; i < bed.size(); ++i) {
    const float gone = std::max(0.0F, before.data()[i] - bed.data()[i]);
    const float detail = start.data()[i] - before.data()[i], thick = surface.data()[i] - bed.data()[i];
    bed.data()[i] = std::min(start.data()[i], before.data()[i] - gone + detail * std::exp(-gone * per_cell));
    surface.data()[i] = bed.data()[i] + std::max(0.0F, thick);
  }
}

/// Says what a user may not expect.
void say_where_ice_is(const Carved& made, const HeightField& terrain, const RunParams& params, const RunContext& run) {
  if (!std::any_of(terrain.cells().begin(), terrain.cells().end(), [&](float z) { return z > params.ela_m; }))
    return run.say("no ground lies over the equilibrium line, ela_m: there is no ice");
  const int width = terrain.width(), height = terrain.height();
  constexpr float kThick_m = 20.0F;
  bool leaves = false;
  for (int x = 1; x + 1 < width; ++x)
    leaves = leaves || std::max(made.ice.clamped(x, 1), made.ice.clamped(x, height - 2)) > kThick_m;
  for (int y = 1; y + 1 < height; ++y)
    leaves = leaves || std::max(made.ice.clamped(1, y), made.ice.clamped(width - 2, y)) > kThick_m;
  if (leaves) run.say("ice reaches the border and leaves the map there");
}

}  // namespace

Carved run(const HeightField& terrain, ScalarField hardness, const RunParams& params, const RunContext& run) {
  check_params(params);
  if (!hardness.empty()) check_same_size("hardness", hardness.frame(), terrain.frame());
  for (float& value : hardness.cells()) value = std::clamp(value, 0.01F, 1e6F);
  std::vector<HeightField> starts = {terrain};
  std::vector<ScalarField> rock = {std::move(hardness)};
  while (std::min(starts.back().width(), starts.back().height()) >= 2 * kCoarsestSide) {
    starts.push_back(geom::halved(starts.back(), run));
    rock.push_back(rock.back().empty() ? ScalarField() : geom::halved(rock.back(), run));
  }
  const Climate climate{params.ela_m, params.balance_gradient_m_yr_km * 1e-3, params.max_accumulation_m_yr};
  double cost = 0, done = 0, left = params.years;
  for (size_t k = 0; k < starts.size(); ++k) cost += steps_for(starts[k].frame()) / std::pow(4.0, k);
  HeightField bed = starts.back(), surface = bed;
  const RunContext quiet{run.threads, {}, run.cancelled, {}};
  for (size_t k = starts.size(); k-- > 0;) {
    Ice ice(bed, surface, climate);
    for (int i = 0; i < (k + 1 == starts.size() ? kGathering : kSettling); ++i) ice.step(kIceStep_yr, kSweeps, quiet);
    const int steps = left > 0 ? steps_for(bed.frame()) : 0;
    const double years = (k == 0 ? 1.0 : kShareOfRest) * left;
    ScalarField speed(bed.frame());
    for (int i = 0; i < steps; ++i) {
      ice.slide(speed, quiet);
      carve(starts[k], rock[k], {years / steps, params.abrasion, params.widening_m, params.wall_angle_deg}, speed, bed,
            surface, quiet);
      for (int j = 0; j < kBetween; ++j) ice.step(kIceStep_yr, kSweeps, quiet);
      done += std::pow(0.25, k);
      run.report(std::min(1.0, done / cost));
    }
    left -= years;
    if (k == 0) {
      for (int i = 0; i < kSettling; ++i) ice.step(kIceStep_yr, kSweeps, quiet);
      break;
    }
    HeightField finer, finer_surface;
    refine(starts[k], bed, surface, starts[k - 1], finer, finer_surface, run);
    bed = std::move(finer);
    surface = std::move(finer_surface);
  }
  Carved out{std::move(bed), std::move(surface), ScalarField(terrain.frame()), ScalarField(terrain.frame())};
  for (size_t i = 0; i < terrain.size(); ++i) {
    out.ice.data()[i] = out.surface.data()[i] - out.terrain.data()[i];
    out.worn.data()[i] = terrain.data()[i] - out.terrain.data()[i];
  }
  say_where_ice_is(out, terrain, params, run);
  return out;
}

}  // namespace seamount::glacier
