#include "seamount/ops/erosion/refine.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/text.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/water/flow_flats.h"
#include "seamount/geom/water/gullies.h"
#include "seamount/geom/water/path_areas.h"
#include "seamount/model/same_size.h"
#include "seamount/ops/erosion/coarse_rivers.h"

namespace seamount::erosion {
namespace {

constexpr int kRounds = 6;
constexpr int kPitSteps = 4;       ///< cells across that small pits are filled in a round
constexpr int kFailSteps = 8;      ///< cells that a slope fails back in a round
constexpr double kRiverCells = 8;  ///< coarse cells drained by the smallest coarse river
constexpr float kWornOff = 0.1F;   ///< of a coarse cell's width: depth of change that takes half of the detail away
constexpr float kBuried_m = 1.5F;  ///< of sediment that hides half of the detail

int doublings_of(const RefineParams& params) { return std::bit_width(static_cast<unsigned>(params.gather_cells) - 1U); }

double years_of_round(const RefineParams& params) { return params.years / kRounds; }

/// Deviation of the bell curve that soil spreads to in a round.
double creep_m(const RefineParams& params) { return std::sqrt(2.0 * params.creep_m2_yr * years_of_round(params)); }

/// From one of the largest gullies to the next.
double gully_m(const RefineParams& params, double cell_m) { return 0.5 * params.gather_cells * cell_m; }

/// out(x, y) = f(x, y) for all cells.
template <class F>
void each_cell(const Grid<float>& like, const RunContext& run, const F& f) {
  parallel_rows(run, like.width(), like.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < like.width(); ++x) f(x, y);
  });
}

/// The eight neighbours of a cell that there are.
template <class F>
void each_neighbour(const Grid<float>& grid, int x, int y, const F& f) {
  for (size_t k = 0; k < 8; ++k) {
    const int nx = x + geom::kFlowDx[k], ny = y + geom::kFlowDy[k];
    if (nx >= 0 && ny >= 0 && nx < grid.width() && ny < grid.height()) f(grid(nx, ny), geom::kFlowLength[k]);
  }
}

/// How much the coarse terrain has changed, a coarse cell around a place: where wear gives way to what is laid down,
/// ground has not stayed as it was.
float change_around(const CoarseErosion& coarse, double column, double row) {
  float sum = 0.0F;
  for (const double dx : {-1.0, 1.0}) {
    for (const double dy : {-1.0, 1.0})
      sum += std::abs(geom::sample_bilinear(coarse.worn, column + dx, row + dy) -
                      geom::sample_bilinear(coarse.before, column + dx, row + dy));
  }
  return 0.25F * sum;
}

class Refinement {
 public:
  Refinement(const HeightField& terrain, const CoarseErosion& coarse, const RefineParams& params, Seed seed,
             const RunContext& run)
      : params_(params),
        run_(run),
        sea_(static_cast<float>(params.sea_m)),
        shore_(std::nextafter(sea_, INFINITY)),
        z_(terrain),
        next_(terrain.frame()) {
    run_.progress = nullptr;
    const GridFrame& frame = terrain.frame();
    const double cell_m2 = coarse.worn.cell_m() * coarse.worn.cell_m();
    const double slope = std::tan(params.angle_deg * std::numbers::pi / 180.0);
    fail_ = static_cast<float>(slope * frame.cell_m);
    ground_ = river_ground(frame, coarse.worn, coarse.flow,
                           {.least_flow = kRiverCells * cell_m2 * runoff_m(), .side_slope = slope, .sea_m = shore_},
                           seed, run_);
    add_detail(terrain, coarse);
    add_gullies(seed);
    let_rivers_pass();
  }

  HeightField result(const RunContext& run) {
    for (int round = 0; round < kRounds && params_.years > 0.0; ++round) {
      run.check_cancelled();
      fill_small_pits();
      cut();
      fail();
      if (params_.creep_m2_yr > 0.0) creep();
      let_rivers_pass();
      run.report((round + 1.0) / kRounds);
    }
    return std::move(z_);
  }

 private:
  double runoff_m() const { return 0.001 * params_.runoff_mm_yr; }
  bool dry(int x, int y) const { return z_(x, y) > sea_; }

  /// That run down the worn slopes, where they are bare and above the sea.
  void add_gullies(Seed seed) {
    if (params_.gullies == 0.0) return;
    each_cell(z_, run_, [&](int x, int y) { next_(x, y) = dry(x, y) ? bare_(x, y) : 0.0F; });
    geom::Gullies gullies;
    gullies.wavelength_m = gully_m(params_, z_.cell_m());
    gullies.strength = params_.gullies;
    geom::add_gullies(z_, seed, gullies, next_, run_);
  }

  /// z_ becomes the worn height and what the terrain differed from its coarse cells.
  void add_detail(const HeightField& terrain, const CoarseErosion& coarse) {
    const GridFrame &fine = terrain.frame(), &large = coarse.worn.frame();
    const auto detail = static_cast<float>(params_.detail), wide = static_cast<float>(large.cell_m);
    const float worn_off = kWornOff * wide;
    const HeightField worn = geom::resample(coarse.worn, fine, run_),
                      before = geom::resample(coarse.before, fine, run_);
    bare_ = ScalarField(fine, 1.0F);
    each_cell(z_, run_, [&](int x, int y) {
      const double column = large.column(fine.x(x)), row = large.row(fine.y(y));
      const float laid = coarse.laid == nullptr ? 0.0F : geom::sample_bilinear(*coarse.laid, column, row) / kBuried_m;
      const float away = geom::smoothstep(ground_.distance(x, y) / wide);
      bare_(x, y) = away / (1.0F + laid * laid);
      // Through all samples at rivers, which are as deep as they are; smoother on the slopes, where that shows cells.
      const auto spread = [&](float through, const HeightField& cells) {
        return away == 0.0F ? through : through + away * (geom::sample_bspline(cells, column, row) - through);
      };
      const float now = spread(worn(x, y), coarse.worn), then = spread(before(x, y), coarse.before);
      const float change = change_around(coarse, column, row) / worn_off;
      z_(x, y) = now + detail * bare_(x, y) * (terrain(x, y) - then) / (1.0F + change * change);
    });
  }

  /// Nothing stands in the way of the coarse rivers.
  void let_rivers_pass() {
    each_cell(z_, run_, [&](int x, int y) { z_(x, y) = std::min(z_(x, y), ground_.highest(x, y)); });
  }

  void fill_small_pits() {
    for (int step = 0; step < kPitSteps; ++step) {
      each_cell(z_, run_, [&](int x, int y) {
        float lowest = INFINITY;
        each_neighbour(z_, x, y, [&](float z, float) { lowest = std::min(lowest, z); });
        next_(x, y) = dry(x, y) ? std::max(z_(x, y), lowest) : z_(x, y);
      });
      std::swap(z_, next_);
    }
  }

  /// One implicit step along the steepest way, each cell towards where its receiver was.
  void cut() {
    const geom::FlowDirections directions = geom::steepest_directions(z_, sea_, run_);
    const Grid<uint32_t> areas = geom::path_areas(directions, doublings_of(params_), run_);
    const double cell_m = z_.cell_m();
    const auto rate = static_cast<float>(params_.erodibility * years_of_round(params_) / cell_m);
    const auto channel = static_cast<float>(params_.channel_m2 / (cell_m * cell_m));
    const auto runoff = static_cast<float>(runoff_m() * cell_m * cell_m);
    each_cell(z_, run_, [&](int x, int y) {
      const uint8_t code = directions(x, y);
      next_(x, y) = z_(x, y);
      if (code >= geom::kOutlet) return;
      const auto area = static_cast<float>(areas(x, y));
      const float flow = runoff * std::max(0.0F, area - channel);
      const float f = rate * std::sqrt(flow) / geom::kFlowLength[code];
      const float to = std::max(shore_, z_(x + geom::kFlowDx[code], y + geom::kFlowDy[code]));
      next_(x, y) = (z_(x, y) + f * to) / (1.0F + f);
    });
    std::swap(z_, next_);
  }

  void fail() {
    for (int step = 0; step < kFailSteps; ++step) {
      each_cell(z_, run_, [&](int x, int y) {
        float highest = z_(x, y);
        each_neighbour(z_, x, y, [&](float z, float length) {
          highest = std::min(highest, std::max(z, shore_) + fail_ * length);
        });
        next_(x, y) = dry(x, y) ? highest : z_(x, y);
      });
      std::swap(z_, next_);
    }
  }

  /// On land; the shore stays where it is.
  void creep() {
    next_ = z_;
    geom::gaussian_blur(next_, creep_m(params_), run_);
    each_cell(z_, run_, [&](int x, int y) {
      if (dry(x, y)) z_(x, y) = std::max(next_(x, y), shore_);
    });
  }

  const RefineParams& params_;
  RunContext run_;
  float sea_, shore_;  ///< and the lowest land
  float fail_ = 0.0F;
  HeightField z_, next_;
  ScalarField bare_;  ///< 1: neither rivers nor what was laid down hide the detail
  RiverGround ground_;
};

void check_coarse(const HeightField& terrain, const CoarseErosion& coarse) {
  check_same_size("worn", coarse.worn.frame(), coarse.before.frame());
  check_same_size("flow", coarse.flow.frame(), coarse.before.frame());
  if (coarse.laid != nullptr) check_same_size("sediment", coarse.laid->frame(), coarse.before.frame());
  const double ratio = coarse.worn.cell_m() / terrain.cell_m();
  if (!(ratio >= 1.0 - 1e-9 && ratio <= 64.0 + 1e-9)) {
    throw IncompatibleInputs("worn has cells of " + format_number(coarse.worn.cell_m()) + " m, the terrain of " +
                             format_number(terrain.cell_m()) + " m: as large to 64 times as large are meant");
  }
}

}  // namespace

Reach refine_reach(const RefineParams& params, double cell_m) {
  const int gather = (1 << doublings_of(params)) + 1;
  const int round = kPitSteps + gather + 1 + kFailSteps + geom::blur_reach(creep_m(params), cell_m);
  const Reach gullies = geom::gullies_reach(gully_m(params, cell_m), cell_m);
  return Reach::neighbourhood(gullies.cells + kRounds * round, gullies.step);
}

HeightField refine(const HeightField& terrain, const CoarseErosion& coarse, const RefineParams& params, Seed seed,
                   const RunContext& run) {
  check_params(params);
  check_coarse(terrain, coarse);
  return Refinement(terrain, coarse, params, seed, run.part(0.0, 0.1)).result(run.part(0.1, 1.0));
}

}  // namespace seamount::erosion
