#include "seamount/ops/contour/move/squeeze.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/scalar/segment.h"
#include "seamount/geom/scalar/spline.h"

namespace seamount::contour {
namespace {

constexpr int64_t kBlock = 256;

/// 1 / max |d/du (u (4 u (1 - u))^k)| on [0, 1]. The derivative is (4 u (1 - u))^(k - 1) 4 u ((k + 1) (1 - u) - k u).
double bound(int k) {
  constexpr int kSteps = 4096;
  double steepest = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double u = static_cast<double>(i) / kSteps;
    double slope = 4.0 * u * ((k + 1) * (1.0 - u) - k * u);
    for (int j = 1; j < k; ++j) slope *= 4.0 * u * (1.0 - u);
    steepest = std::max(steepest, std::abs(slope));
  }
  return 1.0 / steepest;
}

geom::Box grown(Vec2 a, Vec2 b, double by) {
  return {{std::min(a.x, b.x) - by, std::min(a.y, b.y) - by}, {std::max(a.x, b.x) + by, std::max(a.y, b.y) + by}};
}

bool overlap(const geom::Box& a, const geom::Box& b) {
  return a.low.x <= b.high.x && a.high.x >= b.low.x && a.low.y <= b.high.y && a.high.y >= b.low.y;
}

}  // namespace

Squeeze::Squeeze(const Polyline& stroke, double radius_m, int k)
    : line_(geom::sample_catmull_rom(stroke, 0.05 * radius_m)),
      radius_m_(radius_m),
      displacement_(k),
      scale_(bound(k)) {
  if (line_.size() == 1) line_.push_back(line_[0]);
  reach_ = geom::bounding_box(line_);
  reach_ = {reach_.low - Vec2{radius_m, radius_m}, reach_.high + Vec2{radius_m, radius_m}};
}

double Squeeze::squared_distance(size_t piece, Vec2 place, Vec2& nearest) const {
  nearest = geom::nearest_on_segment(place, line_[piece], line_[piece + 1]);
  const Vec2 off = place - nearest;
  return dot(off, off);
}

Vec2 Squeeze::moved(double strength, Vec2 place, std::span<const size_t> near) const {
  double best = radius_m_ * radius_m_;
  Vec2 closest;
  bool found = false;
  for (const size_t piece : near) {
    Vec2 nearest;
    const double squared = squared_distance(piece, place, nearest);
    if (!(squared < best)) continue;
    best = squared;
    closest = nearest;
    found = true;
  }
  if (!found) return place;
  return place - (strength * share(std::sqrt(best) / radius_m_)) * (place - closest);
}

void Squeeze::move(double strength, std::span<Vec2> places, const RunContext& run) const {
  parallel_blocks(run, static_cast<int64_t>(places.size()), kBlock, [&](int64_t begin, int64_t end) {
    const auto block = places.subspan(static_cast<size_t>(begin), static_cast<size_t>(end - begin));
    geom::Box box{block[0], block[0]};
    for (const Vec2 p : block) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    std::vector<size_t> near;
    for (size_t i = 0; i + 1 < line_.size(); ++i) {
      if (overlap(box, grown(line_[i], line_[i + 1], radius_m_))) near.push_back(i);
    }
    for (Vec2& p : block) p = moved(strength, p, near);
  });
}

bool Squeeze::touches(const geom::Box& box) const {
  for (size_t i = 0; i + 1 < line_.size(); ++i) {
    if (overlap(box, grown(line_[i], line_[i + 1], radius_m_))) return true;
  }
  return false;
}

}  // namespace seamount::contour
