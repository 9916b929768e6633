#include "seamount/ops/contour/move/drag.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/scalar/spline.h"

namespace seamount::contour {
namespace {

constexpr int64_t kBlock = 256;  ///< neighbours along a contour are near each other, so few steps reach a block

double squared_distance(const geom::Box& box, Vec2 p) {
  const double dx = std::max({box.low.x - p.x, 0.0, p.x - box.high.x});
  const double dy = std::max({box.low.y - p.y, 0.0, p.y - box.high.y});
  return dx * dx + dy * dy;
}

geom::Box box_of(std::span<const Vec2> places) {
  geom::Box box{places[0], places[0]};
  for (const Vec2 p : places) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

/// Vertices of equal steps along a polyline, its ends among them.
Polyline equal_steps(const Polyline& line, double longest) {
  const double length = geom::line_length(line);
  const int count = std::max(1, static_cast<int>(std::ceil(length / longest - 1e-9)));
  Polyline vertices = {line.front()};
  double before = 0.0;
  size_t segment = 1;
  for (int i = 1; i < count; ++i) {
    const double at = length * i / count;
    double here = std::hypot(line[segment].x - line[segment - 1].x, line[segment].y - line[segment - 1].y);
    while (segment + 1 < line.size() && before + here < at) {
      before += here;
      ++segment;
      here = std::hypot(line[segment].x - line[segment - 1].x, line[segment].y - line[segment - 1].y);
    }
    vertices.push_back(line[segment - 1] +
                       std::clamp((at - before) / here, 0.0, 1.0) * (line[segment] - line[segment - 1]));
  }
  vertices.push_back(line.back());
  return vertices;
}

}  // namespace

Drag::Drag(const Polyline& stroke, double radius_m, double segment_m, Displacement displacement)
    : radius_m_(radius_m), displacement_(std::move(displacement)) {
  const Polyline fine = geom::sample_catmull_rom(stroke, 0.1 * segment_m);
  const Polyline vertices = equal_steps(fine, segment_m);
  for (size_t i = 0; i + 1 < vertices.size(); ++i) {
    const Vec2 d = vertices[i + 1] - vertices[i];
    const double length = std::hypot(d.x, d.y);
    if (length > 0.0) steps_.push_back({vertices[i], (1.0 / length) * d, length});
  }
  reach_ = box_of(vertices);
  reach_.low = reach_.low - Vec2{radius_m, radius_m};
  reach_.high = reach_.high + Vec2{radius_m, radius_m};
}

/// The chord through p along the direction is 2 half long and p lies `along` from its middle.
Vec2 Drag::moved_by(const DragStep& step, double strength, Vec2 place) const {
  const Vec2 from = place - step.centre;
  const double along = dot(from, step.direction);
  const double across = cross(step.direction, from);
  const double half_squared = radius_m_ * radius_m_ - across * across;
  if (!(along * along < half_squared)) return place;
  const double half = std::sqrt(half_squared);
  const double width = half / radius_m_;
  double fade = width * width;
  for (int i = 1; i < displacement_.softness(); ++i) fade *= width * width;
  const double u = 0.5 + 0.5 * along / half;
  return place + (strength * step.step_m * width * fade * displacement_(u)) * step.direction;
}

Vec2 Drag::moved(double strength, Vec2 place) const {
  for (const DragStep& step : steps_) place = moved_by(step, strength, place);
  return place;
}

void Drag::move_block(double strength, std::span<Vec2> places) const {
  geom::Box box = box_of(places);
  for (const DragStep& step : steps_) {
    if (squared_distance(box, step.centre) >= radius_m_ * radius_m_) continue;
    for (Vec2& p : places) p = moved_by(step, strength, p);
    box = box_of(places);
  }
}

void Drag::move(double strength, std::span<Vec2> places, const RunContext& run) const {
  parallel_blocks(run, static_cast<int64_t>(places.size()), kBlock, [&](int64_t begin, int64_t end) {
    move_block(strength, places.subspan(static_cast<size_t>(begin), static_cast<size_t>(end - begin)));
  });
}

bool Drag::touches(const geom::Box& box) const {
  return std::any_of(steps_.begin(), steps_.end(),
                     [&](const DragStep& step) { return squared_distance(box, step.centre) < radius_m_ * radius_m_; });
}

}  // namespace seamount::contour
