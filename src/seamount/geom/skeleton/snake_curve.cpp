// See snake_curve.h.
#include "seamount/geom/skeleton/snake_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seamount/geom/polygon/predicates.h"
#include "seamount/geom/scalar/segment.h"
#include "seamount/geom/skeleton/tangles.h"

namespace seamount::geom {
namespace {

/// Share of the target by which a length may miss it for an energy of 1.
constexpr double kTolerance = 0.05;
/// A growing curve is drawn out by this much, so that no step costs it length.
constexpr double kGrowingAim = 1.02;
/// No vertex goes further than this share of u in a step, or a spacing.
constexpr double kReach = 1.0 / 64.0;
constexpr double kFanAngle = std::numbers::pi / 2.4;
/// A new end keeps this many spacings from the rest of its curve.
constexpr double kClearance = 1.5;

}  // namespace

SnakeLine::SnakeLine(const SnakeOptions& options, double length_m, double unit_m, double least_spacing_m)
    : external_(options.external),
      shape_(options.shape),
      gradient_(options.gradient),
      length_m_(length_m),
      aim_m_(length_m) {
  elastic_.weight = options.internal;
  elastic_.unit_m = unit_m;
  elastic_.bend_m = options.bend_m > 0.0 ? options.bend_m : unit_m / 40.0;
  elastic_.spacing_m =
      options.spacing_m > 0.0 ? std::clamp(options.spacing_m, unit_m / 10000.0, unit_m / 4.0) : unit_m / 64.0;
  elastic_.spacing_m = std::max(elastic_.spacing_m, least_spacing_m);
  elastic_.keeps_length = length_m > 0.0;
}

double SnakeLine::mean_field() const {
  double sum = 0.0;
  for (const double value : field_) sum += value;
  return field_.empty() ? 0.0 : sum / static_cast<double>(field_.size());
}

void SnakeLine::turn_uphill() {
  if (field_.empty() || field_.front() <= field_.back()) return;
  std::reverse(points.begin(), points.end());
  std::reverse(hold.begin(), hold.end());
  std::reverse(field_.begin(), field_.end());
  std::reverse(slope_.begin(), slope_.end());
  std::reverse(fit_.begin(), fit_.end());
}

SnakeLine::Means SnakeLine::means() const {
  Means sums;
  double length = 0.0;
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 edge = points[i + 1] - points[i];
    const double l = std::hypot(edge.x, edge.y), rise = field_[i + 1] - field_[i];
    if (!(l > 0.0)) continue;
    length += l;
    sums.gain += 0.5 * l * (field_[i] + field_[i + 1]);
    sums.steepness += l * steepness(slope_units(rise, l)).value;
  }
  return length > 0.0 ? Means{sums.gain / length, sums.steepness / length} : Means{};
}

void SnakeLine::add_stencils(std::span<const Vec2> line, std::vector<Vec2>& places) const {
  const double reach = 0.25 * elastic_.spacing_m;
  for (const Vec2 p : line) {
    places.insert(places.end(),
                  {p, p + Vec2{-reach, 0.0}, p + Vec2{reach, 0.0}, p + Vec2{0.0, -reach}, p + Vec2{0.0, reach}});
  }
}

void SnakeLine::read(std::span<const double> stencils, std::vector<double>& field, std::vector<Vec2>& slope,
                     std::vector<char>& fit) const {
  const size_t n = stencils.size() / kSnakeStencil;
  const double reach = 0.25 * elastic_.spacing_m;
  field.resize(n);
  slope.resize(n);
  fit.resize(n);
  for (size_t i = 0; i < n; ++i) {
    const double* v = stencils.data() + kSnakeStencil * i;
    fit[i] = std::isfinite(v[0]) ? 1 : 0;
    field[i] = fit[i] != 0 ? v[0] : floor_;
    slope[i] = {slope_between(v[1], field[i], v[2], reach), slope_between(v[3], field[i], v[4], reach)};
  }
}

void SnakeLine::start(std::span<const double> stencils, bool grows) {
  double lowest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < stencils.size(); i += kSnakeStencil) {
    if (std::isfinite(stencils[i])) lowest = std::min(lowest, stencils[i]);
  }
  if (energies.empty()) floor_ = (std::isfinite(lowest) ? lowest : 0.0) - field_unit;
  read(stencils, field_, slope_, fit_);
  if (energies.empty()) energies.push_back(energy(points, field_));
  const double r = std::max(elastic_.bend_m, elastic_.spacing_m);
  care_.start((std::abs(external_) + std::abs(gradient_) + elastic_.weight + 1e-6) * elastic_.spacing_m /
              (elastic_.unit_m * r * r));
  aim_m_ = grows ? std::min(length_m_, kGrowingAim * length()) : length_m_;
}

double SnakeLine::shape_energy(double length, double target_m) const {
  if (!has_target()) return 0.0;
  const double miss = (target_m - length) / (kTolerance * target_m);
  return shape_ * miss * miss;
}

double SnakeLine::energy(std::span<const Vec2> line, std::span<const double> field, double target_m) const {
  double length = 0.0, gain = 0.0, steep = 0.0;
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 edge = line[i + 1] - line[i];
    const double l = std::hypot(edge.x, edge.y), rise = field[i + 1] - field[i];
    length += l;
    gain += 0.5 * l * (field[i] + field[i + 1]);
    if (l > 0.0) steep += l * steepness(slope_units(rise, l)).value;
  }
  return elastic_energy(elastic_, line) - gain_factor(length) * gain + shape_energy(length, target_m) -
         steep_factor(length) * steep;
}

std::vector<Vec2> SnakeLine::slope_of_energy(std::vector<Vec2>& slope_of_length) const {
  const size_t n = points.size();
  std::vector<Vec2> slope(n);
  slope_of_length.assign(n, Vec2{});
  add_elastic_slope(elastic_, points, slope);
  const double by_length =
      has_target() ? -2.0 * shape_ * (aim_m_ - length()) / (kTolerance * kTolerance * aim_m_ * aim_m_) : 0.0;
  const double gain_per_metre = gain_factor(length());
  const double steep_per_metre = steep_factor(length());
  const Means mean = has_target() ? means() : Means{};
  for (size_t i = 0; i + 1 < n; ++i) {
    const Vec2 edge = points[i + 1] - points[i];
    const double l = std::hypot(edge.x, edge.y);
    if (!(l > 0.0)) continue;
    const Vec2 tangent = (1.0 / l) * edge;
    const double incline = slope_units(field_[i + 1] - field_[i], l);
    const Steepness steep = steepness(incline);
    const double pull = by_length - gain_per_metre * (0.5 * (field_[i] + field_[i + 1]) - mean.gain) -
                        steep_per_metre * (steep.value - incline * steep.by_slope - mean.steepness);
    slope_of_length[i] = slope_of_length[i] - tangent;
    slope_of_length[i + 1] = slope_of_length[i + 1] + tangent;
    const double by_field = -0.5 * gain_per_metre * l,
                 by_rise = -steep_per_metre * steep.by_slope * slope_units(1.0, 1.0);
    slope[i] = slope[i] - pull * tangent + (by_field - by_rise) * slope_[i];
    slope[i + 1] = slope[i + 1] + pull * tangent + (by_field + by_rise) * slope_[i + 1];
  }
  return slope;
}

const std::vector<Vec2>& SnakeLine::propose() {
  std::vector<Vec2> slope_of_length;
  const std::vector<Vec2> slope = slope_of_energy(slope_of_length);
  std::vector<double> free(points.size());
  for (size_t i = 0; i < free.size(); ++i) free[i] = 1.0 - std::clamp(static_cast<double>(hold[i]), 0.0, 1.0);
  const double stiffness = has_target() ? 2.0 * shape_ / (kTolerance * kTolerance * aim_m_ * aim_m_) : 0.0;
  const auto [step, per_metre] = elastic_step(elastic_, slope, free, care_.damping, {stiffness, slope_of_length});
  const double reach = std::max(elastic_.spacing_m, kReach * elastic_.unit_m);
  double longest = 0.0;
  for (const Vec2 s : step) longest = std::max(longest, std::hypot(s.x, s.y));
  const double scale = longest > reach ? reach / longest : 1.0;
  proposal_ = points;
  double wanted = length();
  for (size_t i = 0; i < step.size(); ++i) {
    proposal_[i] = points[i] + scale * step[i];
    wanted += scale * dot(step[i], slope_of_length[i]);
  }
  // A turn lengthens a stiff line in second order, which would keep steps short: take it back.
  for (int round = 0; round < 2 && !per_metre.empty(); ++round) {
    const double excess = chain_length(proposal_, false) - wanted;
    for (size_t i = 0; i < step.size(); ++i) proposal_[i] = proposal_[i] - excess * per_metre[i];
  }
  return proposal_;
}

void SnakeLine::judge(std::span<const double> stencils, double least_gain) {
  std::vector<double> field;
  std::vector<Vec2> slope;
  std::vector<char> fit, moved(points.size(), 1);
  read(stencils, field, slope, fit);
  for (size_t i = 0; i < points.size(); ++i) {
    if (fit[i] == 0 && fit_[i] != 0) {
      moved[i] = 0;
      proposal_[i] = points[i];
    }
  }
  const bool simple = undo_tangles(points, proposal_, false, moved);
  for (size_t i = 0; i < points.size(); ++i) {
    if (moved[i] != 0) continue;
    field[i] = field_[i];
    slope[i] = slope_[i];
    fit[i] = fit_[i];
  }
  const double now = simple ? energy(proposal_, field) : std::numeric_limits<double>::infinity();
  const bool lower = now < energies.back() && energy(proposal_, field, aim_m_) < energy(points, field_, aim_m_);
  if (!lower) {
    care_.refuse();
    return;
  }
  care_.accept(energies.back() - now, least_gain);
  points.swap(proposal_);
  field_.swap(field);
  slope_.swap(slope);
  fit_.swap(fit);
  energies.push_back(now);
}

void SnakeLine::add_fans(std::vector<Vec2>& places) const {
  const size_t n = points.size();
  for (const bool at_front : {true, false}) {
    const Vec2 end = at_front ? points[0] : points[n - 1];
    const Vec2 ahead = end - (at_front ? points[1] : points[n - 2]);
    const double scale = elastic_.spacing_m / std::max(std::hypot(ahead.x, ahead.y), 1e-300);
    for (size_t k = 0; k < kFan; ++k) {
      const double angle = kFanAngle * (2.0 * static_cast<double>(k) / (kFan - 1.0) - 1.0);
      const double c = scale * std::cos(angle), s = scale * std::sin(angle);
      const Vec2 edge = {c * ahead.x - s * ahead.y, s * ahead.x + c * ahead.y};
      for (size_t far = 1; far <= kAhead; ++far) places.push_back(end + static_cast<double>(far) * edge);
    }
  }
}

bool SnakeLine::is_clear(Vec2 p, bool at_front) const {
  const size_t n = points.size();
  constexpr size_t kNear = 3;  // the edges next to the end may come nearer
  const double least = kClearance * elastic_.spacing_m;
  const size_t end = at_front ? 0 : n - 1, last = at_front ? 0 : n - 2;
  if (p == points[end] || turns_back(points[at_front ? 1 : n - 2], points[end], p)) return false;
  for (size_t i = 0; i + 1 < n; ++i) {
    if (i == last) continue;
    const size_t steps = at_front ? i : last - i;
    if (steps >= kNear && squared_distance_to_segment(p, points[i], points[i + 1]) < least * least) return false;
    if (segments_meet(points[end], p, points[i], points[i + 1])) return false;
  }
  return true;
}

bool SnakeLine::add_edge(std::span<const Vec2> fans, std::span<const double> values) {
  struct Choice {
    double energy;
    size_t place;
  };
  const auto is_front = [](size_t place) { return place < kFan * kAhead; };
  std::vector<Choice> choices;
  const size_t n = points.size();
  const double h = elastic_.spacing_m;
  const double gain_per_metre = gain_factor(length() + h), steep_per_metre = steep_factor(length() + h);
  const Means mean = means();
  const double longer = shape_energy(length() + h, length_m_) - shape_energy(length(), length_m_);
  const double rigidity = elastic_.weight * elastic_.bend_m * elastic_.bend_m / (elastic_.unit_m * h * h * h);
  for (size_t k = 0; k < kFans; k += kAhead) {
    if (!std::isfinite(values[k])) continue;
    double promise = 0.0;  // of what lies ahead, the nearest first
    for (size_t far = 0; far < kAhead; ++far) {
      promise += (std::isfinite(values[k + far]) ? values[k + far] : floor_) / static_cast<double>(kAhead);
    }
    const size_t end = is_front(k) ? 0 : n - 1, before = is_front(k) ? 1 : n - 2;
    const Vec2 bend = points[before] - 2.0 * points[end] + fans[k];
    const double rise = values[k] - field_[end];
    choices.push_back({longer + rigidity * dot(bend, bend) - gain_per_metre * h * (promise - mean.gain) -
                           steep_per_metre * h * (steepness(slope_units(rise, h)).value - mean.steepness),
                       k});
  }
  std::sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) {
    return a.energy < b.energy || (a.energy == b.energy && a.place < b.place);
  });
  for (const Choice& choice : choices) {
    const bool at_front = is_front(choice.place);
    if (!is_clear(fans[choice.place], at_front)) continue;
    const auto insert = [&](auto& list, auto value) { list.insert(at_front ? list.begin() : list.end(), value); };
    std::vector<Vec2> longer_line = points;
    std::vector<double> longer_field = field_;
    insert(longer_line, fans[choice.place]);
    insert(longer_field, values[choice.place]);
    const double now = energy(longer_line, longer_field);
    if (!(now < energies.back())) return false;
    points.swap(longer_line);
    field_.swap(longer_field);
    insert(hold, 0.0F);
    insert(slope_, Vec2{});
    insert(fit_, char{1});
    energies.push_back(now);
    return true;
  }
  return false;
}

void SnakeLine::take_edges() {
  while (has_target() && points.size() > 2 && length() > length_m_ + 0.5 * elastic_.spacing_m) {
    double best = energies.back();
    int end = -1;
    const std::span<const Vec2> line = points;
    const std::span<const double> field = field_;
    const size_t n = points.size();
    for (const int front : {0, 1}) {
      if (hold[front == 1 ? 0 : n - 1] > 0.0F) continue;
      const size_t from = front == 1 ? 1 : 0;
      const double now = energy(line.subspan(from, n - 1), field.subspan(from, n - 1));
      if (now < best) {
        best = now;
        end = front;
      }
    }
    if (end < 0) return;
    const auto take = [&](auto& list) { list.erase(end == 1 ? list.begin() : list.end() - 1); };
    take(points);
    take(field_);
    take(hold);
    take(slope_);
    take(fit_);
    energies.push_back(best);
  }
}

}  // namespace seamount::geom
