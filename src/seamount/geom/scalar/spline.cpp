#include "seamount/geom/scalar/spline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/base/text.h"

namespace seamount::geom {
namespace {

double length(Vec2 a) { return std::hypot(a.x, a.y); }

Vec2 unit(Vec2 a) {
  const double l = length(a);
  return l > 0.0 ? (1.0 / l) * a : Vec2{};
}

Polyline without_repeats(const Polyline& line) {
  Polyline kept;
  for (const Vec2 p : line) {
    if (kept.empty() || !(p == kept.back())) kept.push_back(p);
  }
  return kept;
}

/// Barry and Goldman's pyramid for the segment p1 p2 with knots at centripetal distances, at share t of it.
Vec2 centripetal_point(Vec2 p0, Vec2 p1, Vec2 p2, Vec2 p3, double t) {
  const double t1 = std::sqrt(length(p1 - p0));
  const double t2 = t1 + std::sqrt(length(p2 - p1));
  const double t3 = t2 + std::sqrt(length(p3 - p2));
  const double u = t1 + t * (t2 - t1);
  const auto mix = [u](Vec2 a, Vec2 b, double from, double to) {
    return ((to - u) / (to - from)) * a + ((u - from) / (to - from)) * b;
  };
  const Vec2 a1 = mix(p0, p1, 0.0, t1);
  const Vec2 a2 = mix(p1, p2, t1, t2);
  const Vec2 a3 = mix(p2, p3, t2, t3);
  return mix(mix(a1, a2, 0.0, t2), mix(a2, a3, t1, t3), t1, t2);
}

Vec2 vertex_tangent(const Polyline& line, size_t i) {
  const Vec2 in = i > 0 ? unit(line[i] - line[i - 1]) : Vec2{};
  const Vec2 out = i + 1 < line.size() ? unit(line[i + 1] - line[i]) : Vec2{};
  const Vec2 mean = unit(in + out);
  return mean == Vec2{} ? out : mean;
}

}  // namespace

Polyline sample_catmull_rom(const Polyline& control, double step_m) {
  constexpr double kMostSamples = 10e6;
  if (!(step_m > 0.0)) throw InvalidArgument("step_m", format_number(step_m) + " is not above 0");
  const Polyline points = without_repeats(control);
  if (points.size() < 2) return points;
  Polyline samples = {points.front()};
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 p1 = points[i];
    const Vec2 p2 = points[i + 1];
    const Vec2 p0 = i > 0 ? points[i - 1] : 2.0 * p1 - p2;
    const Vec2 p3 = i + 2 < points.size() ? points[i + 2] : 2.0 * p2 - p1;
    double arc = 0.0;
    Vec2 before = p1;
    constexpr int kProbes = 16;
    for (int k = 1; k <= kProbes; ++k) {
      const Vec2 p = centripetal_point(p0, p1, p2, p3, static_cast<double>(k) / kProbes);
      arc = std::max(arc, length(p - before) * kProbes);
      before = p;
    }
    const double wanted = std::ceil(arc / step_m);
    if (!(wanted + static_cast<double>(samples.size()) <= kMostSamples))
      throw InvalidArgument("points", "the line is too long for its detail: from (" + format_number(p1.x) + ", " +
                                          format_number(p1.y) + ") to (" + format_number(p2.x) + ", " +
                                          format_number(p2.y) + ") it takes " + format_number(wanted) + " steps of " +
                                          format_number(step_m) + " m");
    const int steps = std::max(1, static_cast<int>(wanted));
    for (int k = 1; k < steps; ++k) {
      samples.push_back(centripetal_point(p0, p1, p2, p3, static_cast<double>(k) / steps));
    }
    samples.push_back(p2);
  }
  return samples;
}

Closest closest_on_polyline(const Polyline& line, Vec2 p) {
  if (line.empty()) throw InvalidArgument("line", "has no point");
  Closest best;
  best.point = line.front();
  best.distance = length(p - line.front());
  double best_squared = std::numeric_limits<double>::infinity();
  size_t best_segment = 0;
  double best_t = 0.0;
  double along = 0.0;
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 a = line[i];
    const Vec2 d = line[i + 1] - a;
    const double squared = dot(d, d);
    const double t = squared > 0.0 ? std::clamp(dot(p - a, d) / squared, 0.0, 1.0) : 0.0;
    const Vec2 off = p - (a + t * d);
    const double segment = std::sqrt(squared);
    if (dot(off, off) < best_squared) {
      best_squared = dot(off, off);
      best_segment = i;
      best_t = t;
      best.point = a + t * d;
      best.along = along + t * segment;
    }
    along += segment;
  }
  if (line.size() < 2) return best;
  best.distance = std::sqrt(best_squared);
  const Vec2 mixed =
      (1.0 - best_t) * vertex_tangent(line, best_segment) + best_t * vertex_tangent(line, best_segment + 1);
  best.tangent = unit(mixed);
  if (best.tangent == Vec2{}) best.tangent = unit(line[best_segment + 1] - line[best_segment]);
  return best;
}

}  // namespace seamount::geom
