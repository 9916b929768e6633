#include "seamount/geom/contour/sheet.h"

#include <algorithm>
#include <cmath>

#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/polygon/predicates.h"

namespace seamount::geom {
namespace {

Vec2 middle_of(const Box& box) { return 0.5 * (box.low + box.high); }

std::vector<Vec2> all_places(const std::vector<ValuedLine>& lines) {
  std::vector<Vec2> places;
  for (const ValuedLine& line : lines) places.insert(places.end(), line.points.begin(), line.points.end());
  return places;
}

Ring ring_of(const Box& box) { return {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}; }

bool holds_box(const Ring& ring, const Box& box) {
  constexpr int kSteps = 16;
  const Ring corners = ring_of(box);
  for (size_t side = 0; side < corners.size(); ++side)
    for (int i = 0; i < kSteps; ++i) {
      const double t = static_cast<double>(i) / kSteps;
      if (!contains(ring, (1.0 - t) * corners[side] + t * corners[(side + 1) % corners.size()])) return false;
    }
  return true;
}

/// The largest upright rectangle, about: each side as far in as the border's places on its side are.
Box box_in(const Ring& ring) {
  const Box around = bounding_box(ring);
  const Vec2 middle = middle_of(around);
  const double half_x = 0.5 * (around.high.x - around.low.x), half_y = 0.5 * (around.high.y - around.low.y);
  Box box = around;
  for (const Vec2 p : ring) {
    const double u = (p.x - middle.x) / half_x, v = (p.y - middle.y) / half_y;
    if (std::abs(u) >= std::abs(v)) {
      if (u < 0) box.low.x = std::max(box.low.x, p.x);
      if (u > 0) box.high.x = std::min(box.high.x, p.x);
    }
    if (std::abs(v) >= std::abs(u)) {
      if (v < 0) box.low.y = std::max(box.low.y, p.y);
      if (v > 0) box.high.y = std::min(box.high.y, p.y);
    }
  }
  const Vec2 centre = middle_of(box);
  for (int i = 0; i < 200; ++i) {
    const double slack = 1e-9 * std::max(half_x, half_y);
    const Box inner = {box.low + Vec2{slack, slack}, box.high - Vec2{slack, slack}};
    if (holds_box(ring, inner)) break;
    box = {centre + 0.99 * (box.low - centre), centre + 0.99 * (box.high - centre)};
  }
  return box;
}

}  // namespace

SheetBorder::SheetBorder(Ring ring) : ring_(std::move(ring)) {
  if (signed_area(ring_) < 0.0) std::reverse(ring_.begin(), ring_.end());
  starts_.push_back(0.0);
  for (size_t i = 0; i < ring_.size(); ++i) {
    const Vec2 way = ring_[(i + 1) % ring_.size()] - ring_[i];
    starts_.push_back(starts_.back() + std::hypot(way.x, way.y));
  }
  const Box box = bounding_box(ring_);
  middle_ = middle_of(box);
  size_ = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
}

SheetBorder::Foot SheetBorder::nearest(Vec2 p) const {
  Foot best{0.0, INFINITY};
  for (size_t i = 0; i < ring_.size(); ++i) {
    const Vec2 a = ring_[i], along = ring_[(i + 1) % ring_.size()] - a;
    const double squared = dot(along, along);
    const double t = squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
    const Vec2 off = p - (a + t * along);
    const double distance = std::hypot(off.x, off.y);
    if (distance < best.distance) best = {starts_[i] + t * (starts_[i + 1] - starts_[i]), distance};
  }
  if (best.arc >= length()) best.arc = 0.0;
  return best;
}

Vec2 SheetBorder::place(double arc, double out) const {
  const auto next = std::upper_bound(starts_.begin(), starts_.end() - 1, arc);
  const auto i = static_cast<size_t>(std::max<std::ptrdiff_t>(next - starts_.begin() - 1, 0));
  const double side = starts_[i + 1] - starts_[i];
  const double t = side > 0.0 ? (arc - starts_[i]) / side : 0.0;
  const Vec2 p = ring_[i] + t * (ring_[(i + 1) % ring_.size()] - ring_[i]);
  return p + out * (p - middle_);
}

Ring SheetBorder::moved(double out) const {
  Ring ring;
  for (const Vec2 p : ring_) ring.push_back(p + out * (p - middle_));
  return ring;
}

void SheetBorder::append_corners(double from, double to, double out, Ring& ring) const {
  const double way = to > from ? to - from : to - from + length();
  for (const double turn : {0.0, length()})
    for (size_t i = 0; i < ring_.size(); ++i) {
      const double arc = starts_[i] + turn;
      if (arc > from && arc < from + way) ring.push_back(ring_[i] + out * (ring_[i] - middle_));
    }
}

Ring rectangle_around(const std::vector<ValuedLine>& lines) { return ring_of(bounding_box(all_places(lines))); }

Ring hull_around(const std::vector<ValuedLine>& lines) {
  std::vector<Vec2> places = all_places(lines);
  std::sort(places.begin(), places.end(), [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  places.erase(std::unique(places.begin(), places.end()), places.end());
  Ring hull;
  const auto add_half = [&](auto begin, auto end) {
    const size_t first = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= first + 2 && orientation_sign(hull[hull.size() - 2], hull.back(), *p) <= 0) hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();
  };
  add_half(places.begin(), places.end());
  add_half(places.rbegin(), places.rend());
  return hull;
}

Ring frame_ring(const GridFrame& frame) {
  return ring_of({{frame.west_m, frame.south_m()}, {frame.east_m(), frame.north_m}});
}

SheetBorder choose_sheet(const std::vector<Ring>& candidates, const std::vector<ValuedLine>& lines, double tolerance) {
  std::optional<SheetBorder> best;
  size_t most = 0;
  for (const Ring& ring : candidates) {
    SheetBorder sheet(ring);
    size_t at = 0, ends = 0;
    for (const ValuedLine& line : lines) {
      if (line.closed || line.points.empty()) continue;
      for (const Vec2 p : {line.points.front(), line.points.back()}) {
        ++ends;
        if (sheet.nearest(p).distance <= tolerance * sheet.size()) ++at;
      }
    }
    if (!best || at > most) best = std::move(sheet), most = at;
    if (at == ends) break;
  }
  return *best;
}

GridFrame frame_in(const SheetBorder& sheet, const GridFrame& wanted) {
  const Box box = box_in(sheet.ring());
  const double slack = 2.0 * wanted.cell_m;
  const auto near = [&](double a, double b) { return std::abs(a - b) <= slack; };
  if (near(box.low.x, wanted.west_m) && near(box.high.x, wanted.east_m()) && near(box.low.y, wanted.south_m()) &&
      near(box.high.y, wanted.north_m))
    return wanted;
  GridFrame frame = wanted;
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  frame.cell_m = std::max({width, height, 1e-3}) / std::max(wanted.width, wanted.height);
  const auto cells = [&](double side) { return std::max(1, static_cast<int>(std::floor(side / frame.cell_m + 1e-9))); };
  frame.width = cells(width);
  frame.height = cells(height);
  frame.west_m = 0.5 * (box.low.x + box.high.x - frame.width_m());
  frame.north_m = 0.5 * (box.low.y + box.high.y + frame.height_m());
  return frame;
}

}  // namespace seamount::geom
