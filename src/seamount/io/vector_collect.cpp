#include "seamount/io/vector_collect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "seamount/base/text.h"

namespace seamount::io {
namespace {

constexpr size_t kMostPoints = 50'000'000;

std::string place(double x, double y) { return fmt::format("({:.10g}, {:.10g})", x, y); }

}  // namespace

void Collector::add(const OGRGeometry& geometry, NamedArea& area, int depth) {
  constexpr int kDeepest = 16;
  if (depth > kDeepest) call_.fail("its collections are nested too deeply");
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbPolygon) {
    add_polygon(*geometry.toPolygon(), area);
  } else if (type == wkbLineString) {
    add_line(*geometry.toLineString());
  } else if (type == wkbPoint) {
    add_point(*geometry.toPoint());
  } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) add(*part, area, depth + 1);
  } else if (OGR_GT_IsNonLinear(type) != 0) {
    const std::unique_ptr<OGRGeometry> linear(geometry.getLinearGeometry());
    if (linear && OGR_GT_IsNonLinear(wkbFlatten(linear->getGeometryType())) == 0) add(*linear, area, depth + 1);
  }
}

void Collector::count(int points) {
  total_ += static_cast<size_t>(points);
  if (total_ > kMostPoints) call_.fail("has more than " + std::to_string(kMostPoints) + " points");
}

Vec2 Collector::finite(Vec2 point) const {
  if (!std::isfinite(point.x) || !std::isfinite(point.y)) call_.fail("has a coordinate that is not finite");
  return point;
}

std::vector<Vec2> Collector::points_of(const OGRSimpleCurve& curve) {
  std::vector<Vec2> points;
  count(curve.getNumPoints());
  for (int i = 0; i < curve.getNumPoints(); ++i) {
    const Vec2 point = finite({curve.getX(i), curve.getY(i)});
    if (points.empty() || !(points.back() == point)) points.push_back(point);
  }
  return points;
}

Ring Collector::ring_of(const OGRLinearRing& from) {
  Ring ring = points_of(from);
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

/// Rings of less than three points enclose nothing and are left out.
void Collector::add_polygon(const OGRPolygon& from, NamedArea& area) {
  if (from.getExteriorRing() == nullptr) return;
  Polygon polygon{ring_of(*from.getExteriorRing()), {}};
  if (polygon.outer.size() < 3) return;
  for (int i = 0; i < from.getNumInteriorRings(); ++i) {
    Ring hole = ring_of(*from.getInteriorRing(i));
    if (hole.size() >= 3) polygon.holes.push_back(std::move(hole));
  }
  area.parts.push_back(std::move(polygon));
}

void Collector::add_point(const OGRPoint& from) {
  if (from.IsEmpty() != 0) return;
  count(1);
  const double z = from.Is3D() != 0 && std::isfinite(from.getZ()) ? from.getZ() * rules_.z_unit_m : 0.0;
  drawing_.points.push_back({finite({from.getX(), from.getY()}), numbers_.value.value_or(z), numbers_.attributes});
}

void Collector::fail_without_height(const OGRLineString& line) const {
  const std::string where =
      "line " + std::to_string(id_) + " at " + place(line.getX(0), line.getY(0)) + " has no height";
  if (rules_.field.empty())
    call_.fail(where + ": no field is named like one; 'height_field' says which it is (fields: " + rules_.fields + ")");
  call_.fail(where + " in its field '" + rules_.field + "' (fields: " + rules_.fields + ")");
}

double Collector::height_of(const OGRLineString& line) {
  if (numbers_.value) return *numbers_.value;
  const bool solid = line.Is3D() != 0 && line.getNumPoints() > 0 && std::isfinite(line.getZ(0));
  if (!solid) {
    if (rules_.required) fail_without_height(line);
    return 0.0;
  }
  const double z = line.getZ(0);
  ++lines_by_z_;
  z_differs_ = z_differs_ || z != 0.0;
  for (int i = 1; rules_.required && i < line.getNumPoints(); ++i) {
    constexpr double kRounding = 0.05;
    if (!(std::abs(line.getZ(i) - z) <= kRounding))
      call_.fail("line " + std::to_string(id_) + " is no contour: its z runs from " + format_number(z) + " to " +
                 format_number(line.getZ(i)) + " at " + place(line.getX(i), line.getY(i)));
  }
  return z * rules_.z_unit_m;
}

void Collector::add_line(const OGRLineString& from) {
  Polyline points = points_of(from);
  const bool closed = points.size() > 3 && points.front() == points.back();
  if (closed) points.pop_back();
  if (points.size() < 2) return;
  const double height = height_of(from);
  drawing_.lines.push_back({std::move(points), height, closed, numbers_.attributes});
}

}  // namespace seamount::io
