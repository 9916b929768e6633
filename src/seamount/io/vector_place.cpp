#include "seamount/io/vector_place.h"

#include <fmt/format.h>
#include <ogr_geometry.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/placement.h"
#include "seamount/io/projection.h"
#include "seamount/io/vector_collect.h"
#include "seamount/io/vector_heights.h"

namespace seamount::io {
namespace {

constexpr double kMostDegrees = 20.0;

struct Box {
  double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
  void include(Vec2 p) {
    x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
    y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
  }
  Vec2 middle() const { return {0.5 * (x0 + x1), 0.5 * (y0 + y1)}; }
};

/// Calls visit(place) with all places of a drawing, one by one.
template <class Visit>
void for_each_point(Drawing& drawing, const Visit& visit) {
  for (NamedArea& area : drawing.areas) {
    for (Polygon& polygon : area.parts) {
      for (Vec2& p : polygon.outer) visit(p);
      for (Ring& hole : polygon.holes)
        for (Vec2& p : hole) visit(p);
    }
  }
  for (ValuedLine& line : drawing.lines)
    for (Vec2& p : line.points) visit(p);
  for (ValuedPoint& point : drawing.points) visit(point.place);
}

Box bounds(Drawing& drawing) {
  Box box;
  for_each_point(drawing, [&](const Vec2& p) { box.include(p); });
  return box;
}

/// The rectangle around the lines, its sides split so that it bends with the coordinates.
Ring sheet_of(const Drawing& drawing) {
  constexpr int kSteps = 64;
  Box box;
  for (const ValuedLine& line : drawing.lines)
    for (const Vec2 p : line.points) box.include(p);
  if (!(box.width() > 0.0 && box.height() > 0.0)) return {};
  const Vec2 corners[] = {{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}};
  Ring ring;
  for (size_t side = 0; side < 4; ++side) {
    const Vec2 a = corners[side], b = corners[(side + 1) % 4];
    for (int i = 0; i < kSteps; ++i) ring.push_back(a + (static_cast<double>(i) / kSteps) * (b - a));
  }
  return ring;
}

/// Joins the parts of an area that was cut along the 180th meridian.
void join_parts(NamedArea& area, const GdalCall& call) {
  OGRMultiPolygon parts;
  const auto to_ring = [](const Ring& ring) {
    auto* made = new OGRLinearRing;
    for (const Vec2& p : ring) made->addPoint(p.x, p.y);
    made->closeRings();
    return made;
  };
  for (const Polygon& polygon : area.parts) {
    auto* made = new OGRPolygon;
    made->addRingDirectly(to_ring(polygon.outer));
    for (const Ring& hole : polygon.holes) made->addRingDirectly(to_ring(hole));
    parts.addGeometryDirectly(made);
  }
  const std::unique_ptr<OGRGeometry> whole(parts.UnionCascaded());
  if (!whole) return;  // not valid shapes: the caller's check of outlines will say so
  Collector collector(call);
  area.parts.clear();
  collector.add(*whole, area);
}

void transform_all(Drawing& drawing, Ring& sheet, const OGRSpatialReference& from, const OGRSpatialReference& to,
                   const GdalCall& call) {
  constexpr size_t kAtOnce = 1 << 16;
  const TransformPtr transform(OGRCreateCoordinateTransformation(&from, &to));
  if (!transform) call.fail("its coordinate reference system cannot be used");
  std::vector<Vec2*> places;
  std::vector<double> x, y;
  std::vector<int> good;
  const auto flush = [&] {
    good.assign(places.size(), 0);
    if (places.empty()) return;
    transform->Transform(static_cast<int>(places.size()), x.data(), y.data(), nullptr, nullptr, good.data());
    for (size_t i = 0; i < places.size(); ++i) {
      if (good[i] == 0 || !std::isfinite(x[i]) || !std::isfinite(y[i]))
        call.fail("has a place that cannot be projected to metres");
      *places[i] = {x[i], y[i]};
    }
    places.clear(), x.clear(), y.clear();
  };
  const auto add = [&](Vec2& p) {
    places.push_back(&p), x.push_back(p.x), y.push_back(p.y);
    if (places.size() == kAtOnce) flush();
  };
  for_each_point(drawing, add);
  for (Vec2& p : sheet) add(p);
  flush();
}

/// One place in longitude and latitude, if it has them.
std::optional<Vec2> degrees_at(Vec2 place, const OGRSpatialReference& system) {
  const OGRSpatialReference lonlat = lonlat_system();
  const TransformPtr transform(OGRCreateCoordinateTransformation(&system, &lonlat));
  if (!transform || transform->Transform(1, &place.x, &place.y) == FALSE) return std::nullopt;
  return std::isfinite(place.x) && std::isfinite(place.y) ? std::optional(place) : std::nullopt;
}

/// The box as a raster of one cell.
Placement placement_of(const Box& box, const OGRSpatialReference& system) {
  Placement placement;
  placement.west = box.x0;
  placement.north = box.y1;
  placement.cell_x = box.width();
  placement.cell_y = box.height();
  placement.system = system;
  return placement;
}

/// Longitude and latitude to a local metric system.
Ring project_degrees(Drawing& drawing, const OGRSpatialReference& system, const GdalCall& call) {
  Box box = bounds(drawing);
  if (box.width() > 180) {
    for_each_point(drawing, [](Vec2& p) { p.x += p.x < 0 ? 360 : 0; });
    box = bounds(drawing);
    for (NamedArea& area : drawing.areas)
      if (area.parts.size() > 1) join_parts(area, call);
  }
  if (box.y0 < -90 || box.y1 > 90 || box.x0 < -360 || box.x1 > 540)
    call.fail("its coordinates are not longitude and latitude in degrees");
  if (box.width() > kMostDegrees)
    call.fail("spans " + format_number(std::round(box.width() * 10) / 10) +
              " degrees of longitude; choose one feature by its name, at most " + format_number(kMostDegrees) +
              " degrees wide");
  const bool known = drawing.frame && !drawing.frame->crs.empty();
  drawing.crs = known ? drawing.frame->crs : local_crs(box.middle().x, box.middle().y);
  Ring sheet = sheet_of(drawing);
  transform_all(drawing, sheet, system, *parse_crs(drawing.crs), call);
  return sheet;
}

Ring keep_metres(Drawing& drawing) { return sheet_of(drawing); }

Ring from_projected(Drawing& drawing, const OGRSpatialReference& system, const GdalCall& call) {
  const Box box = bounds(drawing);
  const std::optional<Vec2> degrees = degrees_at(box.middle(), system);
  const bool metric = std::abs(system.GetLinearUnits(nullptr) - 1.0) < 1e-9;
  if (!degrees && !metric) call.fail("its coordinate reference system cannot be used");
  if (metric && (!degrees || scale_error(placement_of(box, system), 1, 1) <= kMostLengthError)) {
    drawing.crs = crs_text(&system);
    return keep_metres(drawing);
  }
  drawing.crs = local_crs(degrees->x, degrees->y);
  if (drawing.frame && drawing.frame->crs.empty()) drawing.frame.reset();  // it is in the system that is left
  Ring sheet = sheet_of(drawing);
  transform_all(drawing, sheet, system, *parse_crs(drawing.crs), call);
  return sheet;
}

/// Whether all numbers can be longitude and latitude of one place.
bool can_be_degrees(const Box& box) {
  const bool on_earth = box.x0 >= -360 && box.x1 <= 360 && box.y0 >= -90 && box.y1 <= 90;
  return on_earth && box.height() <= kMostDegrees && (box.width() <= kMostDegrees || box.width() >= 360 - kMostDegrees);
}

Ring from_nothing(Drawing& drawing, bool silent, const GdalCall& call, const RunContext& run) {
  const char* const remedy = "; 'crs' states another system";
  if (can_be_degrees(bounds(drawing))) {
    run.say(call.path() +
            ": says no coordinate system; its numbers are taken as longitude and latitude in degrees on WGS 84 "
            "('crs' states another: EPSG:32627, or local for metres)");
    return project_degrees(drawing, lonlat_system(), call);
  }
  if (!silent) run.say(call.path() + ": says no coordinate system; its numbers are taken as metres" + remedy);
  return keep_metres(drawing);
}

}  // namespace

bool is_undefined(const OGRSpatialReference* system) {
  if (system == nullptr || system->IsEmpty() || system->IsLocal() != 0) return true;
  const char* name = system->GetName();
  const std::string lower = lower_case(name != nullptr ? name : "");
  return lower.starts_with("undefined") || lower.starts_with("unspecified");
}

Ring bring_to_metres(Drawing& drawing, const FilePlace& place, const GdalCall& call, const RunContext& run) {
  std::unique_ptr<OGRSpatialReference> stated;
  if (!place.stated.empty() && place.stated != "local") {
    try {
      stated = parse_crs(place.stated);
    } catch (const InvalidArgument& error) {
      throw InvalidArgument("crs", "'" + place.stated.substr(0, 80) +
                                       "' is not a coordinate reference system such as EPSG:32627, nor 'local'");
    }
  }
  const OGRSpatialReference* system = stated ? stated.get() : place.system;
  if (place.stated == "local" || (system != nullptr && system->IsLocal() != 0)) return keep_metres(drawing);
  if (is_undefined(system)) return from_nothing(drawing, system != nullptr, call, run);
  OGRSpatialReference own = *system;
  if (own.IsCompound() != 0) own.StripVertical();
  own = identified(own);
  own.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (own.IsGeographic() == 0) return from_projected(drawing, own, call);
  const Box box = bounds(drawing);
  const bool on_earth = box.x0 >= -360 && box.x1 <= 540 && box.y0 >= -90 && box.y1 <= 90;
  if (!on_earth && !stated && place.assumed_lonlat) {
    run.say(
        call.path() +
        ": its numbers are no longitudes and latitudes, as GeoJSON has them; they are taken as metres ('crs' states "
        "the system)");
    return keep_metres(drawing);
  }
  return project_degrees(drawing, own, call);
}

}  // namespace seamount::io
