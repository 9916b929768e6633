#include "seamount/geom/brush/brush_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/base/text.h"

namespace seamount::geom {
namespace {

constexpr double kFurthest_m = 1e12;
constexpr double kStraight = 1e-3;        // of a radius
constexpr double kStraight_cells = 0.02;  // or of a cell, if that is more
constexpr double kEvenPressure = 5e-3;    // what pressure may differ from a straight line
constexpr double kThinnest_cells = 0.75;  // no line of cells has a gap then
constexpr size_t kMostPieces = 10'000'000;

constexpr double kSpread = 0.2041241452319315;  // of a radius: a Gaussian exp(-12 d^2 / r^2)
constexpr double kStep = 1.0;                   // spreads between samples: Gaussians sum up to 1 within 1e-8
constexpr double kPressurePower = 6.0;          // mass by pressure, about as the greatest pressure times profile has it
constexpr double kLightest = 0.25;              // of the greatest: what is lighter is still seen beside it

/// A place of the pen with its pressure.
struct Touch {
  double x, y, z;
  friend Touch operator+(Touch a, Touch b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Touch operator-(Touch a, Touch b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Touch operator*(double s, Touch a) { return {s * a.x, s * a.y, s * a.z}; }
  Vec2 place() const { return {x, y}; }
};

double distance(Touch a, Touch b) { return std::hypot(b.x - a.x, b.y - a.y); }

std::vector<Touch> touches_of(const Brush& brush, const std::string& name) {
  if (brush.points.empty()) throw InvalidArgument(name + ".points", "has no point");
  const size_t count = brush.points.size();
  if (!brush.pressure.empty() && brush.pressure.size() != count)
    throw InvalidArgument(name + ".pressure", "has " + std::to_string(brush.pressure.size()) + " values for " +
                                                  std::to_string(count) + " points");
  std::vector<Touch> touches;
  touches.reserve(count);
  for (size_t i = 0; i < count; ++i) {
    const Vec2 p = brush.points[i];
    if (!(std::abs(p.x) <= kFurthest_m && std::abs(p.y) <= kFurthest_m))
      throw InvalidArgument(name + ".points", "point " + std::to_string(i) + ", " + format_place(p) + ", is no place");
    const double pressure = brush.pressure.empty() ? 1.0 : brush.pressure[i];
    if (!touches.empty() && touches.back().place() == p) {
      touches.back().z = std::max(touches.back().z, pressure);
    } else {
      touches.push_back({p.x, p.y, pressure});
    }
  }
  return touches;
}

using Bezier = std::array<Touch, 4>;

/// The part from p1 to p2 of the centripetal Catmull-Rom spline (Barry and Goldman's pyramid in Bezier form).
Bezier bezier_of(Touch p0, Touch p1, Touch p2, Touch p3) {
  const double here = std::sqrt(distance(p1, p2));
  const auto knot = [&](Touch a, Touch b) { return a.place() == b.place() ? here : std::sqrt(distance(a, b)); };
  const double before = knot(p0, p1), after = knot(p2, p3);
  const Touch first = (1.0 / before) * (p1 - p0) - (1.0 / (before + here)) * (p2 - p0) + (1.0 / here) * (p2 - p1);
  const Touch last = (1.0 / here) * (p2 - p1) - (1.0 / (here + after)) * (p3 - p1) + (1.0 / after) * (p3 - p2);
  Bezier curve = {p1, p1 + (here / 3.0) * first, p2 - (here / 3.0) * last, p2};
  const auto [low, high] = std::minmax(p1.z, p2.z);  // pressure does not overshoot
  curve[1].z = std::clamp(curve[1].z, low, high);
  curve[2].z = std::clamp(curve[2].z, low, high);
  return curve;
}

bool reaches(const Bezier& curve, const Box& box) {
  const auto [west, east] = std::minmax({curve[0].x, curve[1].x, curve[2].x, curve[3].x});
  const auto [south, north] = std::minmax({curve[0].y, curve[1].y, curve[2].y, curve[3].y});
  return west <= box.high.x && east >= box.low.x && south <= box.high.y && north >= box.low.y;
}

/// A curve differs from its chord, run at an even pace, by at most 3/4 of its control points' second differences.
bool is_straight(const Bezier& curve, double tolerance_m) {
  const Touch a = curve[0] - 2.0 * curve[1] + curve[2], b = curve[1] - 2.0 * curve[2] + curve[3];
  const double off = std::max(std::hypot(a.x, a.y), std::hypot(b.x, b.y));
  return 0.75 * off <= tolerance_m && 0.75 * std::max(std::abs(a.z), std::abs(b.z)) <= kEvenPressure;
}

std::pair<Bezier, Bezier> halves(const Bezier& c) {
  const auto middle = [](Touch a, Touch b) { return 0.5 * (a + b); };
  const Touch ab = middle(c[0], c[1]), bc = middle(c[1], c[2]), cd = middle(c[2], c[3]);
  const Touch abc = middle(ab, bc), bcd = middle(bc, cd), all = middle(abc, bcd);
  return {{c[0], ab, abc, all}, {all, bcd, cd, c[3]}};
}

/// Appends the ends of straight parts of a curve; a part that does not reach the box is one.
void flatten(const Bezier& whole, const Box& box, double tolerance_m, std::vector<Touch>& line,
             const std::string& name) {
  constexpr int kMostHalvings = 60;
  std::vector<std::pair<Bezier, int>> open = {{whole, 0}};
  while (!open.empty()) {
    const auto [curve, depth] = open.back();
    open.pop_back();
    if (depth == kMostHalvings || !reaches(curve, box) || is_straight(curve, tolerance_m)) {
      line.push_back(curve[3]);
      if (line.size() > kMostPieces)
        throw InvalidArgument(name + ".points", "the stroke is too long and too winding for its radius");
      continue;
    }
    const auto [first, second] = halves(curve);
    open.emplace_back(second, depth + 1);
    open.emplace_back(first, depth + 1);
  }
}

std::vector<Touch> straight_parts(const std::vector<Touch>& touches, const Box& box, double tolerance_m,
                                  const std::string& name) {
  std::vector<Touch> line = {touches.front()};
  for (size_t i = 0; i + 1 < touches.size(); ++i) {
    const Touch p1 = touches[i], p2 = touches[i + 1];
    const Touch p0 = i > 0 ? touches[i - 1] : 2.0 * p1 - p2;
    const Touch p3 = i + 2 < touches.size() ? touches[i + 2] : 2.0 * p2 - p1;
    flatten(bezier_of(p0, p1, p2, p3), box, tolerance_m, line, name);
  }
  return line;
}

/// The shares of the line from a to b between which it is inside a box (Liang and Barsky 1984); false where it is not.
bool inside(Vec2 a, Vec2 b, const Box& box, double& from, double& to) {
  const Vec2 d = b - a;
  from = 0.0;
  to = 1.0;
  const auto cut = [&](double room, double outwards) {  // the side that is `room` away, approached `outwards`
    if (outwards > 0) to = std::min(to, room / outwards);
    if (outwards < 0) from = std::max(from, room / outwards);
    if (outwards == 0 && room < 0) to = -1.0;
  };
  cut(a.x - box.low.x, -d.x);
  cut(box.high.x - a.x, d.x);
  cut(a.y - box.low.y, -d.y);
  cut(box.high.y - a.y, d.y);
  return from <= to;
}

/// The samples inside a box: places at multiples of `step` along the line, of which there are `count` + 1.
std::vector<BrushSample> even_steps(const std::vector<Touch>& line, double step, double count, const Box& box,
                                    const std::string& name) {
  std::vector<BrushSample> samples;
  double before = 0.0, next = 0.0;  // length up to the part, in steps; the first sample that is still to come
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const Touch a = line[i], b = line[i + 1];
    const double length = distance(a, b) / step;
    const bool last = i + 2 == line.size();
    double from = 0.0, to = 1.0;
    if (length > 0.0 && inside(a.place(), b.place(), box, from, to)) {
      for (double k = std::max(next, std::ceil(before + from * length - 1e-9)); k <= count; ++k) {
        const double share = (k - before) / length;
        if (share > to + (last ? 1e-6 : 0.0)) break;
        const Touch p = a + std::clamp(share, 0.0, 1.0) * (b - a);
        samples.push_back({p.place(), p.z, k == 0.0 || k == count ? 0.5 : 1.0});
        next = k + 1.0;
        if (samples.size() > kMostPieces)
          throw InvalidArgument(name + ".points", "the stroke is too long for its radius");
      }
    }
    before += length;
  }
  return samples;
}

double length_of(const std::vector<Touch>& line) {
  double length = 0.0;
  for (size_t i = 0; i + 1 < line.size(); ++i) length += distance(line[i], line[i + 1]);
  return length;
}

/// Masses in metres. At its two ends a stroke has half the mass of a dab besides, which makes them round.
void give_mass(const Brush& brush, double step, BrushPath& path) {
  double most = 1.0;
  if (!brush.pressure.empty()) most = *std::max_element(brush.pressure.begin(), brush.pressure.end());
  if (!(most > 0.0)) most = 1.0;
  const double dab = path.spread_m * std::sqrt(2.0 * std::numbers::pi);
  for (BrushSample& sample : path.samples) {
    const bool end = sample.mass < 1.0;
    const double along = sample.mass * step, all = along + (end ? 0.5 * dab : 0.0);
    sample.spread_m2 = all > 0.0 ? path.spread_m * path.spread_m * along / all : 0.0;
    sample.mass = all / dab * std::pow(std::hypot(sample.pressure / most, kLightest), kPressurePower);
    path.even = path.even && sample.pressure == path.samples.front().pressure;
  }
}

BrushProfile profile_of(const Brush& brush, double radius_m, double cell_m) {
  const double fall = std::clamp((1.0 - brush.hardness) * radius_m, std::min(cell_m, radius_m), radius_m);
  return {radius_m - fall, fall};
}

}  // namespace

double BrushProfile::weight(double distance_m) const {
  const auto raised = [](double v) { return v + std::sqrt(v * v + kBrushRounding * kBrushRounding) - kBrushRounding; };
  const double part = distance_m / radius_m(), rounded = raised(part * part) / raised(1.0);
  const double s = std::clamp((std::sqrt(rounded) * radius_m() - plateau_m) / fall_m, 0.0, 1.0);
  const double rest = 1.0 - s * s;
  return rest * rest * rest;
}

BrushPath brush_path(const Brush& brush, const GridFrame& frame, const std::string& name) {
  const std::vector<Touch> touches = touches_of(brush, name);
  const double radius = std::max(brush.radius_m, kThinnest_cells * frame.cell_m);
  const Box sight = {{frame.west_m - radius, frame.south_m() - radius},
                     {frame.east_m() + radius, frame.north_m + radius}};
  BrushPath path;
  path.profile = profile_of(brush, radius, frame.cell_m);
  path.thinned = brush.radius_m / radius;
  path.spread_m = kSpread * radius;
  const double tolerance = std::max(kStraight * radius, kStraight_cells * frame.cell_m);
  std::vector<Touch> line = straight_parts(touches, sight, tolerance, name);
  const double length = length_of(line), count = std::ceil(length / (kStep * path.spread_m));
  const double step = count > 0.0 ? length / count : 0.0;
  if (count > 0.0) {
    path.samples = even_steps(line, step, count, sight, name);
  } else if (double from = 0.0, to = 0.0; inside(touches[0].place(), touches[0].place(), sight, from, to)) {
    path.samples = {{touches[0].place(), touches[0].z, 0.5}};
  }
  give_mass(brush, step, path);
  for (const BrushSample& sample : path.samples) {
    const Vec2 low = sample.at - Vec2{radius, radius}, high = sample.at + Vec2{radius, radius};
    if (path.box.empty()) path.box = {low, high};
    path.box.low = {std::min(path.box.low.x, low.x), std::min(path.box.low.y, low.y)};
    path.box.high = {std::max(path.box.high.x, high.x), std::max(path.box.high.y, high.y)};
  }
  return path;
}

}  // namespace seamount::geom
