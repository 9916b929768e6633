// See region_line.h.
#include "seamount/geom/skeleton/region_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "seamount/geom/skeleton/tangles.h"

namespace seamount::geom {
namespace {

constexpr double kTolerance = 0.05;
/// Two places of Gauss' quadrature on [0, 1].
constexpr double kGauss[2] = {0.21132486540518713, 0.78867513459481287};
constexpr int kMostPieces = 16;

double circumference(double area) { return 2.0 * std::sqrt(std::numbers::pi * area); }

double shoelace(std::span<const Vec2> ring) {
  double sum = 0.0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
    sum += cross(a, b);
  }
  return 0.5 * sum;
}

}  // namespace

RegionLine::RegionLine(const RegionOptions& options, double area_m2, double unit_m2, Vec2 middle, double least_raster_m,
                       double least_spacing_m)
    : inside_(options.inside),
      border_(options.border),
      shape_(options.shape),
      target_m2_(area_m2),
      unit_m2_(unit_m2),
      aim_m2_(area_m2) {
  const double unit = circumference(unit_m2);
  elastic_.closed = true;
  elastic_.weight = options.internal;
  elastic_.unit_m = unit;
  elastic_.bend_m = options.bend_m > 0.0 ? options.bend_m : unit / 60.0;
  elastic_.keeps_length = area_m2 > 0.0;
  spacing_m_ = options.spacing_m > 0.0 ? std::clamp(options.spacing_m, unit / 10000.0, unit / 8.0) : unit / 96.0;
  spacing_m_ = std::max(spacing_m_, least_spacing_m);
  elastic_.spacing_m = spacing_m_;
  raster = FieldRaster(middle, options.raster_m > 0.0 ? options.raster_m : std::max(unit / 128.0, least_raster_m));
  quadrature_ = std::clamp(static_cast<int>(std::ceil(spacing_m_ / raster.cell_m())), 1, kMostPieces);
}

double RegionLine::radius_m() const { return std::sqrt(unit_m2_ / std::numbers::pi); }

Box RegionLine::reach_of(std::span<const Vec2> line) const {
  Box box = {line[0], line[0]};
  for (const Vec2 p : line) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  const Vec2 margin = {2.0 * raster.cell_m(), 2.0 * raster.cell_m()};
  return {box.low - margin, box.high + margin};
}

void RegionLine::measure(double field_unit) {
  const FieldRaster::Spread spread = raster.spread();
  const double deviation = 2.0 * spread.deviation;
  const bool flat = !(deviation > 1e-9 * std::abs(spread.mean));
  field_unit_ = field_unit > 0.0 ? field_unit : (flat ? std::max(std::abs(spread.mean), 1.0) : deviation);
  raster.set_floor(spread.lowest - field_unit_);
}

bool RegionLine::seed(Vec2 at) {
  const double unit = radius_m();
  for (double radius = 0.25 * unit; radius > 0.02 * unit; radius *= 0.7) {
    const int n = std::max(12, static_cast<int>(std::lround(2.0 * std::numbers::pi * radius / spacing_m_)));
    points.clear();
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / n;
      points.push_back(at + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    hold.assign(points.size(), 0.0F);
    if (raster.fit(at) && std::all_of(points.begin(), points.end(), [&](Vec2 p) { return raster.fit(p); })) return true;
  }
  points.clear();
  hold.clear();
  return false;
}

RegionLine::Measures RegionLine::measure(std::span<const Vec2> line) const {
  Measures sums;
  sums.area = shoelace(line);
  for (size_t i = 0; i < line.size(); ++i) {
    const Vec2 edge = line[(i + 1) % line.size()] - line[i];
    const double length = std::hypot(edge.x, edge.y), weight = 0.5 / quadrature_;
    sums.length += length;
    for (int k = 0; k < quadrature_; ++k) {
      for (const double gauss : kGauss) {
        const Vec2 at = line[i] + ((k + gauss) / quadrature_) * edge;
        sums.inside += weight * edge.y * raster.integral_to(at);
        if (border_ != 0.0) sums.border += weight * length * raster.at(at);
      }
    }
  }
  return sums;
}

double RegionLine::mean_field() const {
  if (points.size() < 3) return 0.0;
  const Measures sums = measure(points);
  return sums.area > 0.0 ? sums.inside / sums.area : 0.0;
}

double RegionLine::shape_energy(double area, double aim_m2) const {
  if (!has_target()) return 0.0;
  const double miss = (aim_m2 - area) / (kTolerance * aim_m2);
  return shape_ * miss * miss;
}

double RegionLine::energy(std::span<const Vec2> line, double aim_m2) const {
  const Measures sums = measure(line);
  const double area = has_target() ? std::max(sums.area, 1e-300) : unit_m2_;
  const double length = has_target() ? std::max(sums.length, 1e-300) : elastic_.unit_m;
  return elastic_energy(elastic_, line) + shape_energy(sums.area, aim_m2) -
         (inside_ * sums.inside / area + border_ * sums.border / length) / field_unit_;
}

std::vector<Vec2> RegionLine::slope_of_energy(std::vector<Vec2>& slope_of_area) const {
  const size_t n = points.size();
  std::vector<Vec2> slope(n);
  slope_of_area.assign(n, Vec2{});
  add_elastic_slope(elastic_, points, slope);
  const Measures sums = measure(points);
  const double area = has_target() ? sums.area : unit_m2_, length = has_target() ? sums.length : elastic_.unit_m;
  const double mean_inside = has_target() ? sums.inside / area : 0.0;
  const double mean_border = has_target() ? sums.border / length : 0.0;
  const double by_inside = inside_ / (field_unit_ * area), by_border = border_ / (field_unit_ * length);
  const double by_area =
      has_target() ? -2.0 * shape_ * (aim_m2_ - sums.area) / (kTolerance * kTolerance * aim_m2_ * aim_m2_) : 0.0;
  const double reach = 0.5 * raster.cell_m(), weight = 0.5 / quadrature_;
  for (size_t i = 0; i < n; ++i) {
    const size_t j = (i + 1) % n;
    const Vec2 edge = points[j] - points[i], outwards = {edge.y, -edge.x};  // times its length
    slope_of_area[i] = slope_of_area[i] + 0.5 * outwards;
    slope_of_area[j] = slope_of_area[j] + 0.5 * outwards;
    const double edge_length = std::hypot(edge.x, edge.y);
    double border = 0.0;
    for (int k = 0; k < quadrature_; ++k) {
      for (const double gauss : kGauss) {
        const double share = (k + gauss) / quadrature_;
        const Vec2 at = points[i] + share * edge;
        const double field = raster.at(at);
        Vec2 push = (-weight * by_inside * (field - mean_inside)) * outwards;
        if (border_ != 0.0) {
          const Vec2 incline = {(raster.at(at + Vec2{reach, 0.0}) - raster.at(at - Vec2{reach, 0.0})) / (2.0 * reach),
                                (raster.at(at + Vec2{0.0, reach}) - raster.at(at - Vec2{0.0, reach})) / (2.0 * reach)};
          push = push - (weight * by_border * edge_length) * incline;
          border += weight * field;
        }
        slope[i] = slope[i] + (1.0 - share) * push;
        slope[j] = slope[j] + share * push;
      }
    }
    if (border_ == 0.0 || !(edge_length > 0.0)) continue;
    const Vec2 pull = (-by_border * (border - mean_border) / edge_length) * edge;
    slope[i] = slope[i] - pull;
    slope[j] = slope[j] + pull;
  }
  for (size_t i = 0; i < n; ++i) slope[i] = slope[i] + by_area * slope_of_area[i];
  return slope;
}

void RegionLine::start(double growth) {
  const double area = this->area();
  if (has_target()) aim_m2_ = std::clamp(target_m2_, area / growth, area * growth);
  const double h = chain_length(points, true) / static_cast<double>(points.size());
  elastic_.spacing_m = h;
  const double r = std::max(elastic_.bend_m, h);
  care_.start((std::abs(inside_) + std::abs(border_) + elastic_.weight + 1e-6) * h / (elastic_.unit_m * r * r));
}

const std::vector<Vec2>& RegionLine::propose() {
  std::vector<Vec2> slope_of_area;
  const std::vector<Vec2> slope = slope_of_energy(slope_of_area);
  std::vector<double> free(points.size());
  for (size_t i = 0; i < free.size(); ++i) free[i] = 1.0 - std::clamp(static_cast<double>(hold[i]), 0.0, 1.0);
  const double stiffness = has_target() ? 2.0 * shape_ / (kTolerance * kTolerance * aim_m2_ * aim_m2_) : 0.0;
  const auto [step, per_area] = elastic_step(elastic_, slope, free, care_.damping, {stiffness, slope_of_area});
  double longest = 0.0, wanted = area();
  for (const Vec2 s : step) longest = std::max(longest, std::hypot(s.x, s.y));
  const double scale = longest > spacing_m_ ? spacing_m_ / longest : 1.0;
  proposal_ = points;
  for (size_t i = 0; i < step.size(); ++i) {
    proposal_[i] = points[i] + scale * step[i];
    wanted += scale * dot(step[i], slope_of_area[i]);
  }
  if (!per_area.empty()) {  // what the step changes the area by in second order is taken back
    const double excess = shoelace(proposal_) - wanted;
    for (size_t i = 0; i < step.size(); ++i) proposal_[i] = proposal_[i] - excess * per_area[i];
  }
  return proposal_;
}

/// Takes vertices back that would go to unfit places, or carry the middle of an edge there; whether there were any.
bool RegionLine::keep_fit(std::vector<char>& moved) {
  const size_t n = points.size();
  bool any = false;
  const auto take_back = [&](size_t i) {
    any = any || moved[i] != 0;
    moved[i] = 0;
    proposal_[i] = points[i];
  };
  for (size_t i = 0; i < n; ++i) {
    if (!raster.fit(proposal_[i]) && raster.fit(points[i])) take_back(i);
  }
  for (size_t i = 0; i < n; ++i) {
    const size_t j = (i + 1) % n;
    if (raster.fit(0.5 * (proposal_[i] + proposal_[j])) || !raster.fit(0.5 * (points[i] + points[j]))) continue;
    take_back(i);
    take_back(j);
  }
  return any;
}

void RegionLine::judge(double least_gain) {
  if (!raster.covers(reach_of(proposal_))) return care_.stop();
  std::vector<char> moved(points.size(), 1);
  keep_fit(moved);
  // A vertex that is taken back may put its edges where they do not fit, or cross; what does not settle is refused.
  bool settled = false;
  for (int round = 0; round < 3 && !settled; ++round) {
    if (!undo_tangles(points, proposal_, true, moved)) return care_.refuse();
    settled = !keep_fit(moved);
  }
  if (!settled || !(shoelace(proposal_) > 0.0)) return care_.refuse();
  const double before = energy(points, aim_m2_), after = energy(proposal_, aim_m2_);
  const double all_before = before - shape_energy(area(), aim_m2_) + shape_energy(area(), target_m2_);
  const double grown = shoelace(proposal_);
  const double all_after = after - shape_energy(grown, aim_m2_) + shape_energy(grown, target_m2_);
  if (!(after < before) || !(all_after < all_before)) return care_.refuse();
  care_.accept(before - after, least_gain);
  points.swap(proposal_);
  steps.push_back({all_before, all_after});
}

bool RegionLine::is_uneven() const {
  const double mean = chain_length(points, true) / static_cast<double>(points.size());
  double longest = 0.0;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec2 edge = points[(i + 1) % points.size()] - points[i];
    longest = std::max(longest, std::hypot(edge.x, edge.y));
  }
  return mean > 1.25 * spacing_m_ || mean < 0.75 * spacing_m_ || longest > 2.0 * spacing_m_;
}

void RegionLine::spread() {
  std::vector<Vec2> before = points;
  std::vector<float> hold_before = hold;
  const auto held = std::find_if(hold.begin(), hold.end(), [](float h) { return h > 0.0F; });
  if (held != hold.end()) {
    std::rotate(points.begin(), points.begin() + (held - hold.begin()), points.end());
    std::rotate(hold.begin(), hold.begin() + (held - hold.begin()), hold.end());
  }
  points.push_back(points[0]);
  hold.push_back(hold[0]);
  spread_chain(points, hold, spacing_m_);
  points.pop_back();
  hold.pop_back();
  if (points.size() >= 8 && find_tangles(points, true).empty()) return;
  points.swap(before);
  hold.swap(hold_before);
}

}  // namespace seamount::geom
