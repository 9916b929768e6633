// See snake.h.
#include "seamount/geom/skeleton/snake.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/skeleton/snake_curve.h"
#include "seamount/geom/skeleton/tangles.h"

namespace seamount::geom {
namespace {

constexpr int64_t kSnakesPerBlock = 4;
constexpr int kGrowingSteps = 8;
constexpr double kGrowth = 1.25;
constexpr int kRounds = 3;
constexpr size_t kDirections = 32;
constexpr size_t kUnitPlaces = 80;
/// A curve this many times longer than its target is taken up more coarsely.
constexpr double kMostTargets = 32.0;
constexpr double kMostVertices = 2048.0;

void check(const SnakeOptions& options) {
  const auto hold = [](bool holds, const char* name, const char* rule) {
    if (!holds) throw InvalidArgument(name, rule);
  };
  hold(options.internal >= 0.0 && std::isfinite(options.internal), "internal", "must be a number from 0 on");
  hold(options.shape >= 0.0 && std::isfinite(options.shape), "shape", "must be a number from 0 on");
  hold(std::isfinite(options.external), "external", "must be a number");
  hold(std::isfinite(options.gradient), "gradient", "must be a number");
  hold(options.bend_m >= 0.0 && std::isfinite(options.bend_m), "bend_m", "must be a number from 0 on");
  hold(options.spacing_m >= 0.0 && std::isfinite(options.spacing_m), "spacing_m", "must be a number from 0 on");
  hold(options.field_unit >= 0.0 && std::isfinite(options.field_unit), "field_unit", "must be a number from 0 on");
  hold(options.steps >= 0, "steps", "must not be negative");
  hold(options.least_gain >= 0.0, "least_gain", "must not be negative");
}

/// All snakes that are fitted together.
class Snakes {
 public:
  Snakes(const FieldAtPlaces& field, const SnakeOptions& options, const RunContext& run)
      : options_(options), field_(field), run_(run) {}

  std::vector<SnakeLine> lines;
  std::vector<double> units;  ///< u of each

  void measure_units();
  void seed(std::span<const SnakeSeed> seeds);
  void grow(const std::vector<size_t>& those);
  void relax(const std::vector<size_t>& those, int steps, bool grows);
  /// Edges taken away, added, all relaxed, until nothing is left to add.
  void fit(std::vector<size_t> those);

 private:
  void evaluate() {
    values_.resize(places_.size());
    if (!places_.empty()) field_(places_, values_);
  }
  /// Stencils of `line(i)` for those snakes, in one call of the field; starts_ says where each one's values begin.
  template <class Line>
  void evaluate_stencils(const std::vector<size_t>& those, Line&& line);
  std::span<const double> values_of(size_t k) const {
    return std::span(values_).subspan(starts_[k], starts_[k + 1] - starts_[k]);
  }
  template <class Body>
  void for_each(const std::vector<size_t>& those, Body&& body) {
    parallel_blocks(quiet(), static_cast<int64_t>(those.size()), kSnakesPerBlock, [&](int64_t begin, int64_t end) {
      for (int64_t k = begin; k < end; ++k) body(static_cast<size_t>(k), lines[those[static_cast<size_t>(k)]]);
    });
  }
  RunContext quiet() const {
    RunContext context = run_;
    context.progress = nullptr;
    return context;
  }

  const SnakeOptions& options_;
  const FieldAtPlaces& field_;
  const RunContext& run_;
  std::vector<Vec2> places_;
  std::vector<double> values_;
  std::vector<size_t> starts_;
};

template <class Line>
void Snakes::evaluate_stencils(const std::vector<size_t>& those, Line&& line) {
  places_.clear();
  starts_.assign(1, 0);
  for (const size_t i : those) {
    lines[i].add_stencils(line(lines[i]), places_);
    starts_.push_back(places_.size());
  }
  evaluate();
}

/// Gamma's deviation around each snake, twice, where no unit is given.
void Snakes::measure_units() {
  if (options_.field_unit > 0.0) {
    for (SnakeLine& line : lines) line.field_unit = options_.field_unit;
    return;
  }
  places_.clear();
  for (size_t i = 0; i < lines.size(); ++i) {
    Vec2 middle;
    for (const Vec2 p : lines[i].points) middle = middle + p;
    middle = (1.0 / static_cast<double>(std::max<size_t>(lines[i].points.size(), 1))) * middle;
    for (size_t k = 0; k < kUnitPlaces; ++k) {
      // Evenly over a quarter of the square without being a lattice (Roberts 2018), mirrored into the others.
      const size_t quarter = k / 4;
      const double turn = static_cast<double>(quarter) + 1.0;
      const auto share = [&](double step) { return 0.5 * (turn * step - std::floor(turn * step)); };
      const Vec2 off = {share(0.7548776662466927), share(0.5698402909980532)};
      places_.push_back(middle + units[i] * Vec2{k % 2 == 0 ? off.x : -off.x, k % 4 < 2 ? off.y : -off.y});
    }
  }
  evaluate();
  for (size_t i = 0; i < lines.size(); ++i) {
    double count = 0.0, sum = 0.0, squares = 0.0;
    const std::span<const double> values = std::span(values_).subspan(i * kUnitPlaces, kUnitPlaces);
    for (const double value : values) {
      if (!std::isfinite(value)) continue;
      ++count;
      sum += value;
    }
    for (const double value : values) {
      if (std::isfinite(value)) squares += (value - sum / count) * (value - sum / count);
    }
    const double deviation = count > 0.0 ? std::sqrt(squares / count) : 0.0;
    // Of a field that is flat but for rounding every unit is as good.
    lines[i].field_unit =
        deviation > 1e-9 * std::abs(sum / count) ? 2.0 * deviation : std::max(std::abs(sum / count), 1.0);
  }
}

/// The first edges: one each way, the best of a rose of directions.
void Snakes::seed(std::span<const SnakeSeed> seeds) {
  places_.clear();
  for (size_t i = 0; i < seeds.size(); ++i) {
    const Vec2 d = lines[i].spacing_m() * seeds[i].direction;
    places_.push_back(seeds[i].at);
    for (size_t k = 0; k < kDirections; ++k) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / kDirections;
      const double c = std::cos(angle), s = std::sin(angle);
      places_.push_back(seeds[i].at + Vec2{c * d.x - s * d.y, s * d.x + c * d.y});
    }
  }
  evaluate();
  constexpr double kUnfit = -std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < seeds.size(); ++i) {
    const Vec2* places = places_.data() + i * (kDirections + 1);
    const double* values = values_.data() + i * (kDirections + 1);
    SnakeLine& line = lines[i];
    line.points.clear();
    if (!std::isfinite(values[0])) continue;
    // Along the slope its difference counts for, else against: a contour is where Gamma stays what it is.
    const double steep = options_.gradient > 0.0 ? options_.gradient : std::min(options_.gradient, -1e-3);
    const auto merit = [&](double a, double b) {
      const double rise = (b - a) / line.field_unit * kSlopeShare * units[i] / (2.0 * line.spacing_m());
      return options_.external * (a + b) / (2.0 * line.field_unit) + steep * rise * rise;
    };
    double best = kUnfit;
    size_t found = kDirections;
    for (size_t k = 0; k < kDirections / 2; ++k) {
      const double ahead = values[1 + k], behind = values[1 + k + kDirections / 2];
      if (!std::isfinite(ahead) || !std::isfinite(behind) || !(merit(behind, ahead) > best + 1e-12)) continue;
      best = merit(behind, ahead);
      found = k;
    }
    if (found < kDirections) {
      line.points = {places[1 + found + kDirections / 2], places[0], places[1 + found]};
    } else {
      for (size_t k = 0; k < kDirections; ++k) {
        if (!std::isfinite(values[1 + k]) || !(values[1 + k] > best)) continue;
        best = values[1 + k];
        line.points = {places[0], places[1 + k]};
      }
    }
    line.hold.assign(line.points.size(), 0.0F);
  }
}

void Snakes::relax(const std::vector<size_t>& those, int steps, bool grows) {
  if (those.empty()) return;
  evaluate_stencils(those, [](const SnakeLine& line) { return std::span<const Vec2>(line.points); });
  for_each(those, [&](size_t k, SnakeLine& line) { line.start(values_of(k), grows); });
  std::vector<size_t> active = those;
  std::vector<const std::vector<Vec2>*> proposals(lines.size());
  for (int step = 0; step < steps && !active.empty(); ++step) {
    run_.check_cancelled();
    for_each(active, [&](size_t k, SnakeLine& line) { proposals[active[k]] = &line.propose(); });
    evaluate_stencils(active, [&](const SnakeLine& line) {
      return std::span<const Vec2>(*proposals[static_cast<size_t>(&line - lines.data())]);
    });
    for_each(active, [&](size_t k, SnakeLine& line) { line.judge(values_of(k), options_.least_gain); });
    std::erase_if(active, [&](size_t i) { return lines[i].rests(); });
  }
}

void Snakes::grow(const std::vector<size_t>& those) {
  std::vector<size_t> growing = those;
  std::vector<double> relaxed_at(lines.size());
  std::vector<char> stuck(lines.size(), 0);
  for (const size_t i : those) relaxed_at[i] = lines[i].length();
  for (;;) {
    std::erase_if(growing, [&](size_t i) { return stuck[i] > 1 || !lines[i].wants_edge(); });
    if (growing.empty()) return;
    run_.check_cancelled();
    places_.clear();
    for (const size_t i : growing) lines[i].add_fans(places_);
    evaluate();
    std::vector<char> grew(growing.size());
    for_each(growing, [&](size_t k, SnakeLine& line) {
      constexpr size_t kPlaces = SnakeLine::kFans;
      grew[k] = line.add_edge(std::span(places_).subspan(k * kPlaces, kPlaces),
                              std::span(values_).subspan(k * kPlaces, kPlaces))
                    ? 1
                    : 0;
    });
    std::vector<size_t> due;
    for (size_t k = 0; k < growing.size(); ++k) {
      const size_t i = growing[k];
      stuck[i] = grew[k] != 0 ? 0 : static_cast<char>(stuck[i] + 1);
      if (stuck[i] != 1 && lines[i].length() < kGrowth * relaxed_at[i]) continue;
      due.push_back(i);
    }
    relax(due, kGrowingSteps, true);
    for (const size_t i : due) relaxed_at[i] = lines[i].length();
  }
}

void Snakes::fit(std::vector<size_t> those) {
  for (int round = 0; round < kRounds && !those.empty(); ++round) {
    relax(those, 0, true);  // Gamma where they are
    for_each(those, [](size_t, SnakeLine& line) { line.take_edges(); });
    grow(those);
    relax(those, options_.steps, false);
    std::erase_if(those, [&](size_t i) { return !lines[i].wants_edge(); });
    run_.report((round + 1.0) / kRounds);
  }
}

std::vector<SnakeFit> results_of(std::vector<SnakeLine>& lines) {
  std::vector<SnakeFit> results(lines.size());
  for (size_t i = 0; i < lines.size(); ++i) {
    SnakeLine& line = lines[i];
    SnakeFit& fit = results[i];
    fit.skeleton.kind = SkeletonKind::curve;
    fit.length_m = line.points.empty() ? 0.0 : line.length();
    fit.mean_field = line.mean_field();
    fit.rests = line.rests();
    if (std::any_of(line.hold.begin(), line.hold.end(), [](float h) { return h != 0.0F; })) {
      fit.skeleton.hold = std::move(line.hold);
    }
    fit.skeleton.points = std::move(line.points);
    fit.energies = std::move(line.energies);
  }
  return results;
}

void check(const SnakeCurve& curve, size_t number) {
  const auto refuse = [&](const std::string& problem) {
    throw InvalidArgument("curve " + std::to_string(number + 1), problem);
  };
  const Polyline& points = curve.skeleton.points;
  if (points.size() < 2) refuse("has " + std::to_string(points.size()) + " points; it takes at least 2");
  for (const Vec2 p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) refuse("has a place that is not finite");
  }
  if (!curve.skeleton.hold.empty() && curve.skeleton.hold.size() != points.size()) {
    refuse("has " + std::to_string(curve.skeleton.hold.size()) + " holds for " + std::to_string(points.size()) +
           " points");
  }
  if (!(curve.length_m >= 0.0) || !std::isfinite(curve.length_m)) refuse("has a target length below 0");
}

}  // namespace

std::vector<SnakeFit> grow_snakes(std::span<const SnakeSeed> seeds, const SnakeOptions& options,
                                  const FieldAtPlaces& field, const RunContext& run) {
  check(options);
  Snakes snakes(field, options, run);
  for (size_t i = 0; i < seeds.size(); ++i) {
    const SnakeSeed& seed = seeds[i];
    if (!(seed.length_m > 0.0) || !std::isfinite(seed.length_m)) {
      throw InvalidArgument("seed " + std::to_string(i + 1), "needs a length above 0");
    }
    snakes.lines.emplace_back(options, seed.length_m, seed.length_m, 0.0);
    snakes.lines.back().points = {seed.at};
    snakes.units.push_back(seed.length_m);
  }
  snakes.measure_units();
  snakes.seed(seeds);
  std::vector<size_t> alive;
  for (size_t i = 0; i < seeds.size(); ++i) {
    if (snakes.lines[i].points.size() >= 2) alive.push_back(i);
    if (snakes.lines[i].points.size() < 2) snakes.lines[i].points.clear();
  }
  snakes.fit(std::move(alive));
  if (options.gradient > 0.0) {
    for (SnakeLine& line : snakes.lines) line.turn_uphill();
  }
  return results_of(snakes.lines);
}

std::vector<SnakeFit> fit_snakes(std::span<const SnakeCurve> curves, const SnakeOptions& options,
                                 const FieldAtPlaces& field, const RunContext& run) {
  check(options);
  Snakes snakes(field, options, run);
  std::vector<size_t> sound;
  for (size_t i = 0; i < curves.size(); ++i) {
    check(curves[i], i);
    const Skeleton& skeleton = curves[i].skeleton;
    const double length = chain_length(std::span<const Vec2>(skeleton.points), false);
    const double unit = curves[i].length_m > 0.0 ? curves[i].length_m : length;
    SnakeOptions own = options;
    const double least = length > kMostTargets * unit ? length / kMostVertices : 0.0;
    if (!(curves[i].length_m > 0.0)) own.spacing_m = length / (static_cast<double>(skeleton.points.size()) - 1.0);
    snakes.lines.emplace_back(own, curves[i].length_m, unit > 0.0 ? unit : 1.0, least);
    snakes.units.push_back(unit > 0.0 ? unit : 1.0);
    SnakeLine& line = snakes.lines.back();
    line.points = skeleton.points;
    line.hold = skeleton.hold;
    if (line.hold.empty()) line.hold.assign(line.points.size(), 0.0F);
    if (length > 0.0 && find_tangles(line.points, false).empty()) sound.push_back(i);
  }
  for (const size_t i : sound) {
    if (curves[i].length_m > 0.0)
      spread_chain(snakes.lines[i].points, snakes.lines[i].hold, snakes.lines[i].spacing_m());
  }
  snakes.measure_units();
  snakes.fit(std::move(sound));
  return results_of(snakes.lines);
}

}  // namespace seamount::geom
