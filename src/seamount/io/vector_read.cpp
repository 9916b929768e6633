#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/projection.h"
#include "seamount/io/vector.h"
#include "seamount/io/vector_frame.h"
#include "seamount/io/vector_open.h"
#include "seamount/io/warp.h"

namespace seamount::io {
namespace {

constexpr size_t kMostPoints = 50'000'000;
constexpr double kMostDegrees = 20.0;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Index of the first field with one of these names, any case; -1 if there is none.
int find_field(const OGRFeatureDefn& definition, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    for (int i = 0; i < definition.GetFieldCount(); ++i)
      if (lower(definition.GetFieldDefn(i)->GetNameRef()) == name) return i;
  return -1;
}

int name_field(const OGRFeatureDefn& definition) {
  const int named = find_field(definition, {"name"});
  if (named >= 0) return named;
  for (int i = 0; i < definition.GetFieldCount(); ++i)
    if (definition.GetFieldDefn(i)->GetType() == OFTString) return i;
  return -1;
}

std::string field_text(OGRFeature& feature, int field) {
  return field >= 0 && feature.IsFieldSetAndNotNull(field) != 0 ? feature.GetFieldAsString(field) : "";
}

/// The numbers of a feature but for the one at `value_at`, which is its value.
Attributes field_numbers(OGRFeature& feature, int value_at) {
  Attributes attributes;
  for (int i = 0; i < feature.GetFieldCount(); ++i) {
    const OGRFieldDefn& field = *feature.GetFieldDefnRef(i);
    const OGRFieldType type = field.GetType();
    if (i == value_at || (type != OFTReal && type != OFTInteger && type != OFTInteger64)) continue;
    if (feature.IsFieldSetAndNotNull(i) == 0 || !std::isfinite(feature.GetFieldAsDouble(i))) continue;
    attributes.push_back({field.GetNameRef(), feature.GetFieldAsDouble(i)});
  }
  return attributes;
}

/// Gathers the shapes of features in the file's own coordinates.
class Collector {
 public:
  explicit Collector(const GdalCall& call) : call_(call) {}

  /// Of the feature whose shapes are added from now on. Without a value a line's or point's own z stands for it.
  void begin(std::optional<double> value, Attributes attributes) {
    value_ = value;
    attributes_ = std::move(attributes);
  }

  void add(const OGRGeometry& geometry, NamedArea& area, int depth = 0) {
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

  Drawing& drawing() { return drawing_; }

 private:
  void count(int points) {
    total_ += static_cast<size_t>(points);
    if (total_ > kMostPoints) call_.fail("has more than " + std::to_string(kMostPoints) + " points");
  }

  Vec2 finite(Vec2 point) const {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) call_.fail("has a coordinate that is not finite");
    return point;
  }

  std::vector<Vec2> points_of(const OGRSimpleCurve& curve) {
    std::vector<Vec2> points;
    count(curve.getNumPoints());
    for (int i = 0; i < curve.getNumPoints(); ++i) {
      const Vec2 point = finite({curve.getX(i), curve.getY(i)});
      if (points.empty() || !(points.back() == point)) points.push_back(point);
    }
    return points;
  }

  Ring ring_of(const OGRLinearRing& from) {
    Ring ring = points_of(from);
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
  }

  /// Rings of less than three points enclose nothing and are left out.
  void add_polygon(const OGRPolygon& from, NamedArea& area) {
    if (from.getExteriorRing() == nullptr) return;
    Polygon polygon{ring_of(*from.getExteriorRing()), {}};
    if (polygon.outer.size() < 3) return;
    for (int i = 0; i < from.getNumInteriorRings(); ++i) {
      Ring hole = ring_of(*from.getInteriorRing(i));
      if (hole.size() >= 3) polygon.holes.push_back(std::move(hole));
    }
    area.parts.push_back(std::move(polygon));
  }

  void add_point(const OGRPoint& from) {
    if (from.IsEmpty() != 0) return;
    count(1);
    drawing_.points.push_back(
        {finite({from.getX(), from.getY()}), value_or(from.Is3D() != 0 ? from.getZ() : 0.0), attributes_});
  }

  double value_or(double z) const { return value_.value_or(std::isfinite(z) ? z : 0.0); }

  void add_line(const OGRLineString& from) {
    Polyline points = points_of(from);
    const bool closed = points.size() > 3 && points.front() == points.back();
    if (closed) points.pop_back();
    const double z = from.Is3D() != 0 && from.getNumPoints() > 0 ? from.getZ(0) : 0.0;
    if (points.size() >= 2) drawing_.lines.push_back({std::move(points), value_or(z), closed, attributes_});
  }

  const GdalCall& call_;
  Drawing drawing_;
  std::optional<double> value_;
  Attributes attributes_;
  size_t total_ = 0;
};

/// Layers that write_drawing() makes are read together.
bool is_ours(GDALDataset& dataset) {
  for (int i = 0; i < dataset.GetLayerCount(); ++i) {
    const std::string name = dataset.GetLayer(i) == nullptr ? "" : dataset.GetLayer(i)->GetName();
    if (name != "areas" && name != "lines" && name != "points") return false;
  }
  return dataset.GetLayerCount() > 1;
}

OGRLayer& choose_layer(GDALDataset& dataset, const std::string& wanted, const GdalCall& call) {
  std::vector<std::string> names;
  OGRLayer* first = nullptr;
  OGRLayer* places = nullptr;
  for (int i = 0; i < dataset.GetLayerCount(); ++i) {
    OGRLayer* layer = dataset.GetLayer(i);
    if (layer == nullptr) continue;
    names.push_back(layer->GetName());
    if (names.back() == wanted) return *layer;
    const OGRwkbGeometryType type = wkbFlatten(layer->GetGeomType());
    if (first == nullptr && type != wkbPoint && type != wkbNone) first = layer;
    if (places == nullptr && type == wkbPoint) places = layer;
  }
  if (!wanted.empty()) call.fail("has no layer '" + wanted + "'" + suggestion(wanted, names));
  if (first == nullptr) first = places;
  if (first == nullptr) call.fail("has no layer of areas, lines or points");
  return *first;
}

/// All places of a drawing, one by one.
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

struct Box {
  double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
  double width() const { return x1 - x0; }
};

Box bounds(Drawing& drawing) {
  Box box;
  for_each_point(drawing, [&](const Vec2& p) {
    box.x0 = std::min(box.x0, p.x), box.x1 = std::max(box.x1, p.x);
    box.y0 = std::min(box.y0, p.y), box.y1 = std::max(box.y1, p.y);
  });
  return box;
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

/// Longitude and latitude to a local metric system.
void project_degrees(Drawing& drawing, const OGRSpatialReference& system, const GdalCall& call) {
  const OGRSpatialReference lonlat = lonlat_system();
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
  const auto rounded = [](double degrees) { return std::round(degrees * 1e4) / 1e4; };
  double longitude = rounded(0.5 * (box.x0 + box.x1));
  if (longitude > 180) longitude -= 360;
  const bool known = drawing.frame && !drawing.frame->crs.empty();
  drawing.crs = known ? drawing.frame->crs : local_crs(longitude, rounded(0.5 * (box.y0 + box.y1)));
  const auto metres = parse_crs(drawing.crs);
  const TransformPtr transform(OGRCreateCoordinateTransformation(&system, metres.get()));
  if (!transform) call.fail("its coordinate reference system cannot be used");
  for_each_point(drawing, [&](Vec2& p) {
    if (transform->Transform(1, &p.x, &p.y) == FALSE || !std::isfinite(p.x) || !std::isfinite(p.y))
      call.fail("has a place that cannot be projected to metres");
  });
}

void to_metres(Drawing& drawing, const OGRSpatialReference* system, const GdalCall& call) {
  if (system == nullptr || system->IsEmpty() || system->IsLocal() != 0) return;
  OGRSpatialReference own = identified(*system);
  own.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (own.IsGeographic() != 0) return project_degrees(drawing, own, call);
  if (!is_metric(own)) call.fail("its coordinate reference system is not in metres; reproject it first");
  drawing.crs = crs_text(&own);
}

/// The frame that a file of ours carries.
std::optional<GridFrame> find_frame(GDALDataset& dataset, const std::string& place, const GdalCall& call) {
  if (const char* text = dataset.GetMetadataItem(kFrameItem)) {
    const std::optional<GridFrame> frame = parse_frame(text);
    if (!frame) call.fail(std::string("has a damaged metadata item '") + kFrameItem + "'");
    return frame;
  }
  if (std::string_view(dataset.GetDriverName()) != "GeoJSON") return std::nullopt;
  VSILFILE* file = VSIFOpenL(place.c_str(), "rb");
  if (file == nullptr) return std::nullopt;
  std::string beginning(1 << 14, '\0');
  beginning.resize(VSIFReadL(beginning.data(), 1, beginning.size(), file));
  VSIFCloseL(file);
  try {
    const std::optional<GridFrame> frame = find_frame_member(beginning);
    if (frame && !frame->crs.empty() && !is_metric(*parse_crs(frame->crs)))
      throw InvalidArgument("seamount", "has a crs that is not in metres");
    return frame;
  } catch (const InvalidArgument& error) {
    call.fail(error.what());
  }
}

/// What is read of a file: the names of its features, for suggestions, and whether the wanted one is among them.
struct Reading {
  Collector collector;
  std::vector<std::string> names;
  bool found = false;
  bool heights = false;
};

void read_layer(OGRLayer& layer, const std::string& wanted, const RunContext& run, Reading& reading) {
  constexpr size_t kMostNames = 10000;
  const OGRFeatureDefn& definition = *layer.GetLayerDefn();
  const int name_at = name_field(definition);
  const int value_at = find_field(definition, {"value", "height_m", "elevation", "elev", "height"});
  layer.ResetReading();
  while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) {
    run.check_cancelled();
    const std::string name = field_text(*feature, name_at);
    if (!name.empty() && reading.names.size() < kMostNames) reading.names.push_back(name);
    if (!wanted.empty() && lower(name) != lower(wanted)) continue;
    reading.found = true;
    const Attributes numbers = field_numbers(*feature, value_at);
    NamedArea area{name, {}, numbers};
    const bool valued = value_at >= 0 && feature->IsFieldSetAndNotNull(value_at) != 0;
    reading.collector.begin(valued ? std::optional(feature->GetFieldAsDouble(value_at)) : std::nullopt, numbers);
    if (const OGRGeometry* geometry = feature->GetGeometryRef()) reading.collector.add(*geometry, area);
    if (!area.parts.empty()) reading.collector.drawing().areas.push_back(std::move(area));
  }
  reading.heights |= value_at >= 0 && lower(definition.GetFieldDefn(value_at)->GetNameRef()) == "height_m";
}

Drawing read_dataset(const std::string& place, const GdalCall& call, const VectorOptions& options,
                     const RunContext& run) {
  const DatasetPtr dataset = open_vector(place, call, run);
  Reading reading{Collector(call), {}, false, false};
  std::vector<OGRLayer*> layers;
  if (options.layer.empty() && is_ours(*dataset)) {
    for (int i = 0; i < dataset->GetLayerCount(); ++i) layers.push_back(dataset->GetLayer(i));
  } else {
    layers.push_back(&choose_layer(*dataset, options.layer, call));
  }
  for (OGRLayer* layer : layers) read_layer(*layer, options.feature, run, reading);
  run.check_cancelled();
  call.check("is damaged");
  if (!reading.found && !options.feature.empty())
    call.fail("has no feature '" + options.feature + "'" + suggestion(options.feature, reading.names));
  Drawing drawing = std::move(reading.collector.drawing());
  drawing.heights = reading.heights;
  if (drawing.areas.empty() && drawing.lines.empty() && drawing.points.empty())
    call.fail("has no areas, lines or points in it");
  drawing.frame = find_frame(*dataset, place, call);
  to_metres(drawing, layers[0]->GetSpatialRef(), call);
  if (drawing.frame) drawing.frame->crs = drawing.crs;
  return drawing;
}

}  // namespace

Drawing read_drawing(const std::string& path, const VectorOptions& options, const RunContext& run) {
  check_readable(path);
  check_vector_extension(path);
  const GdalCall call(path);
  return read_dataset(path, call, options, run);
}

Drawing read_geojson(std::span<const uint8_t> bytes, const std::string& name, const VectorOptions& options) {
  GdalCall call(name);
  const MemoryFile memory(bytes, "shapes.geojson");
  call.hide(memory.path());
  return read_dataset(memory.path(), call, options, {});
}

Drawing read_areas(const std::string& path, const VectorOptions& options, const RunContext& run) {
  Drawing drawing = read_drawing(path, options, run);
  if (drawing.areas.empty()) throw IoError(path, "has no areas in it");
  return drawing;
}

std::vector<std::string> feature_names(const std::string& path, const RunContext& run) {
  check_readable(path);
  check_vector_extension(path);
  const GdalCall call(path);
  const DatasetPtr dataset = open_vector(path, call, run);
  OGRLayer& layer = choose_layer(*dataset, "", call);
  const int name_at = name_field(*layer.GetLayerDefn());
  std::vector<std::string> names;
  layer.ResetReading();
  while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) {
    const std::string name = field_text(*feature, name_at);
    if (!name.empty()) names.push_back(name);
    run.check_cancelled();
  }
  run.check_cancelled();
  call.check("is damaged");
  return names;
}

}  // namespace seamount::io
