// See hill_climb.h.
#include "seamount/geom/skeleton/hill_climb.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "seamount/base/error.h"

namespace seamount::geom {
namespace {

/// A place and those around it that its slope is taken from.
constexpr size_t kStencil = 5;

struct Climber {
  Vec2 start;
  Vec2 slope;
  double step = 0.0;
  bool knows_slope = false;
  std::array<Vec2, kStencil> around;
  std::array<double, kStencil> values;
};

void check(const ClimbOptions& options) {
  const auto refuse = [](const char* name, const char* rule) { throw InvalidArgument(name, rule); };
  if (!(options.cell_m > 0.0)) refuse("cell_m", "must be above 0");
  if (!(options.first_step_m >= 0.0)) refuse("first_step_m", "must not be negative");
  if (!(options.least_step_cells > 0.0)) refuse("least_step_cells", "must be above 0");
  if (!(options.least_slope >= 0.0)) refuse("least_slope", "must not be negative");
  if (!(options.most_distance_m >= 0.0)) refuse("most_distance_m", "must not be negative");
  if (options.steps < 0) refuse("steps", "must not be negative");
}

std::array<Vec2, kStencil> stencil(Vec2 p, double reach) {
  return {p, p + Vec2{-reach, 0.0}, p + Vec2{reach, 0.0}, p + Vec2{0.0, -reach}, p + Vec2{0.0, reach}};
}

class Climb {
 public:
  Climb(const ClimbOptions& options, const FieldForPoints& field)
      : options_(options),
        field_(field),
        reach_(0.25 * options.cell_m),
        first_step_(options.first_step_m > 0.0 ? options.first_step_m : options.cell_m) {}

  std::vector<Climbed> run(std::span<const Vec2> points, const RunContext& run) {
    start(points);
    for (int step = 0; step < options_.steps && !active_.empty(); ++step) {
      run.check_cancelled();
      for (const size_t i : active_) propose(i);
      evaluate();
      std::erase_if(active_, [&](size_t i) { return judge(i); });
    }
    return std::move(results_);
  }

 private:
  void start(std::span<const Vec2> points) {
    climbers_.resize(points.size());
    results_.resize(points.size());
    for (size_t i = 0; i < points.size(); ++i) {
      climbers_[i].start = points[i];
      climbers_[i].step = first_step_;
      climbers_[i].around = stencil(points[i], reach_);
      active_.push_back(i);
    }
    evaluate();
    std::erase_if(active_, [&](size_t i) {
      results_[i].at = points[i];
      results_[i].value = climbers_[i].values[0];
      return !std::isfinite(results_[i].value) || stand(i);
    });
  }

  /// All stencils in one call.
  void evaluate() {
    places_.clear();
    whose_.clear();
    for (const size_t i : active_) {
      places_.insert(places_.end(), climbers_[i].around.begin(), climbers_[i].around.end());
      whose_.insert(whose_.end(), kStencil, i);
    }
    values_.resize(places_.size());
    if (!places_.empty()) field_(places_, whose_, values_);
    size_t next = 0;
    for (const size_t i : active_) {
      for (double& value : climbers_[i].values) value = values_[next++];
    }
  }

  /// Takes the slope where a point stands; whether it rests there.
  bool stand(size_t i) {
    Climber& climber = climbers_[i];
    const auto& v = climber.values;
    climber.slope = {slope_between(v[1], v[0], v[2], reach_), slope_between(v[3], v[0], v[4], reach_)};
    const double steepness = std::hypot(climber.slope.x, climber.slope.y);
    results_[i].rests = !(steepness > options_.least_slope);
    climber.knows_slope = true;
    if (!results_[i].rests) climber.slope = (1.0 / steepness) * climber.slope;
    return results_[i].rests;
  }

  void propose(size_t i) {
    Climber& climber = climbers_[i];
    const double step = climber.knows_slope ? climber.step : 0.0;
    climber.around = stencil(results_[i].at + step * climber.slope, reach_);
  }

  bool reaches(const Climber& climber, Vec2 p) const {
    const Vec2 off = p - climber.start;
    return options_.most_distance_m == 0.0 || std::hypot(off.x, off.y) <= options_.most_distance_m;
  }

  /// Goes where it is higher, if it is; whether the point rests now.
  bool judge(size_t i) {
    Climber& climber = climbers_[i];
    if (!climber.knows_slope) return stand(i);
    size_t best = 0;
    for (size_t k = 1; k < kStencil; ++k) {
      if (climber.values[k] > climber.values[best] || !std::isfinite(climber.values[best])) best = k;
    }
    const auto better = [&](size_t k) {
      return std::isfinite(climber.values[k]) && climber.values[k] > results_[i].value &&
             reaches(climber, climber.around[k]);
    };
    if (better(0)) {
      climber.step = std::min(1.5 * climber.step, first_step_);
      accept(i, 0);
      return stand(i);
    }
    climber.step *= 0.5;
    if (better(best)) {
      accept(i, best);
      climber.knows_slope = false;
    }
    results_[i].rests = climber.step < options_.least_step_cells * options_.cell_m;
    return results_[i].rests;
  }

  void accept(size_t i, size_t k) {
    results_[i].at = climbers_[i].around[k];
    results_[i].value = climbers_[i].values[k];
    ++results_[i].steps;
  }

  const ClimbOptions& options_;
  const FieldForPoints& field_;
  double reach_, first_step_;
  std::vector<Climber> climbers_;
  std::vector<Climbed> results_;
  std::vector<size_t> active_;
  std::vector<Vec2> places_;
  std::vector<size_t> whose_;
  std::vector<double> values_;
};

}  // namespace

std::vector<Climbed> hill_climb(std::span<const Vec2> points, const ClimbOptions& options, const FieldForPoints& field,
                                const RunContext& run) {
  check(options);
  return Climb(options, field).run(points, run);
}

std::vector<Climbed> hill_climb(std::span<const Vec2> points, const ClimbOptions& options, const FieldAtPlaces& field,
                                const RunContext& run) {
  const FieldForPoints same = [&](std::span<const Vec2> places, std::span<const size_t>, std::span<double> values) {
    field(places, values);
  };
  return hill_climb(points, options, same, run);
}

}  // namespace seamount::geom
