// What is in values that are no rasters.
#include "buffer.h"
#include "json.h"
#include "seamount/geom/contour/lines.h"
#include "seamount/io/report.h"
#include "seamount/io/vector.h"
#include "seamount/recipe/catalogue_json.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/scene_json.h"
#include "values.h"
#include "work.h"

namespace seamount::python {
namespace {

using recipe::Value;
namespace kinds = recipe::kinds;

py::tuple point(Vec2 p) { return py::make_tuple(p.x, p.y); }

/// The points of a chain; of a ring with the first one again at the end, as GeoJSON wants it.
py::list chain(const Polyline& points, bool closed = false) {
  py::list list;
  for (const Vec2 p : points) list.append(point(p));
  if (closed && !points.empty()) list.append(point(points.front()));
  return list;
}

/// Outer rings counter-clockwise, holes clockwise (RFC 7946).
py::list ring(const Ring& points, bool counter_clockwise) {
  double area = 0;
  for (size_t i = 0; i < points.size(); ++i) area += cross(points[i], points[(i + 1) % points.size()]);
  if ((area > 0) == counter_clockwise) return chain(points, true);
  return chain(Ring(points.rbegin(), points.rend()), true);
}

py::dict geometry(const char* type, const py::object& coordinates) {
  py::dict made;
  made["type"] = type;
  made["coordinates"] = coordinates;
  return made;
}

py::dict feature(const py::dict& shape, py::dict properties) {
  py::dict made;
  made["type"] = "Feature";
  made["properties"] = std::move(properties);
  made["geometry"] = shape;
  return made;
}

py::list polygon(const Polygon& part) {
  py::list rings;
  rings.append(ring(part.outer, true));
  for (const Ring& hole : part.holes) rings.append(ring(hole, false));
  return rings;
}

py::dict area_geometry(const NamedArea& area) {
  if (area.parts.size() == 1) return geometry("Polygon", polygon(area.parts.front()));
  py::list parts;
  for (const Polygon& part : area.parts) parts.append(polygon(part));
  return geometry("MultiPolygon", parts);
}

void add_attributes(py::dict& properties, const Attributes& attributes) {
  for (const Attribute& one : attributes) properties[to_text(one.name)] = one.value;
}

py::list features_of_drawing(const Drawing& drawing) {
  const char* const value = drawing.heights ? "height_m" : "value";
  py::list features;
  for (const NamedArea& area : drawing.areas) {
    py::dict properties;
    properties["name"] = to_text(area.name);
    add_attributes(properties, area.attributes);
    features.append(feature(area_geometry(area), properties));
  }
  for (const ValuedLine& line : drawing.lines) {
    py::dict properties;
    properties[value] = line.value;
    add_attributes(properties, line.attributes);
    features.append(feature(geometry("LineString", chain(line.points, line.closed)), properties));
  }
  for (const ValuedPoint& one : drawing.points) {
    py::dict properties;
    properties[value] = one.value;
    add_attributes(properties, one.attributes);
    features.append(feature(geometry("Point", point(one.place)), properties));
  }
  return features;
}

py::dict properties_of(const Scene& scene, const SceneObject& object) {
  py::dict row;
  row["id"] = object.id;
  row["class"] = to_text(scene.catalogue.classes[static_cast<size_t>(object.of_class)].name);
  row["size"] = object.size;
  row["fitness"] = object.fitness;
  row["born"] = object.born;
  row["age"] = iterations_in(scene, object.window) - object.born;
  row["window"] = object.window;
  row["keep"] = object.keep;
  return row;
}

py::list features_of_scene(const Scene& scene) {
  py::list features;
  for (const SceneObject& object : scene.objects) {
    const Polyline& points = object.skeleton.points;
    py::dict shape;
    if (object.skeleton.kind == SkeletonKind::point) {
      shape = geometry("Point", point(points.front()));
    } else if (object.skeleton.kind == SkeletonKind::curve) {
      shape = geometry("LineString", chain(points));
    } else {
      py::list rings;
      rings.append(ring(points, true));
      shape = geometry("Polygon", rings);
    }
    features.append(feature(shape, properties_of(scene, object)));
  }
  return features;
}

/// (features, coordinate system).
py::tuple features(const Held& held) {
  const Value& value = held.value;
  if (value.is<kinds::Drawing>()) {
    const auto& drawing = value.get<kinds::Drawing>();
    return py::make_tuple(features_of_drawing(drawing), to_text(drawing.crs));
  }
  if (value.is<kinds::Contours>()) {
    const auto& set = value.get<kinds::Contours>();
    return py::make_tuple(features_of_drawing(geom::to_cut_lines(set)), to_text(set.frame.crs));
  }
  if (value.is<kinds::Objects>()) {
    const auto& scene = value.get<kinds::Objects>();
    return py::make_tuple(features_of_scene(scene), to_text(scene.frame.crs));
  }
  throw InvalidArgument("value", "a " + value.kind().name + " has no features");
}

py::tuple drawing(const std::string& geojson, const std::string& crs) {
  io::VectorOptions options;
  options.crs = crs;
  Work work(0, py::none());
  const std::span<const uint8_t> bytes(reinterpret_cast<const uint8_t*>(geojson.data()), geojson.size());
  Held read{
      work.run([&] { return Value::of<kinds::Drawing>(io::read_geojson(bytes, "drawing", options, work.context())); }),
      true};
  return py::make_tuple(py::cast(std::move(read)), to_texts(work.notes()));
}

/// The arrays of a network, by name.
py::dict network(const Held& held) {
  const auto& tin = held.value.get<kinds::Tin>();
  const auto owner = std::make_shared<const Value>(held.value);
  const auto count = [](const auto& list) { return static_cast<Py_ssize_t>(list.size()); };
  py::dict arrays;
  arrays["nodes"] =
      buffer_of(owner, reinterpret_cast<const double*>(tin.nodes.data()), {count(tin.nodes), 2}, held.own);
  arrays["triangles"] =
      buffer_of(owner, reinterpret_cast<const int32_t*>(tin.triangles.data()), {count(tin.triangles), 3}, held.own);
  arrays["region"] = buffer_of(owner, tin.region.data(), {count(tin.region)}, held.own);
  arrays["rank"] = buffer_of(owner, tin.rank.data(), {count(tin.rank)}, held.own);
  arrays["bed_m"] = buffer_of(owner, tin.bed_m.data(), {count(tin.bed_m)}, held.own);
  arrays["height_m"] = buffer_of(owner, tin.height_m.data(), {count(tin.height_m)}, held.own);
  return arrays;
}

/// A number (or `width` of them) of each thing, where it stands in memory.
template <class T>
Buffer column(const std::shared_ptr<const Value>& owner, size_t count, const T* of_first, Py_ssize_t width = 0) {
  Buffer buffer = buffer_of(owner, of_first, {static_cast<Py_ssize_t>(count)}, false);
  buffer.strides[0] = sizeof(Thing);
  if (width > 0) {
    buffer.shape.push_back(width);
    buffer.strides.push_back(buffer.item);
  }
  return buffer;
}

/// The arrays of things, by name; "shapes" their models' names.
py::dict instances(const Held& held) {
  const auto& things = held.value.get<kinds::Things>();
  const auto owner = std::make_shared<const Value>(held.value);
  static const Thing kNone;
  const Thing& first = things.things.empty() ? kNone : things.things.front();
  const size_t count = things.things.size();
  py::dict arrays;
  arrays["place"] = column(owner, count, &first.place.x, 2);
  arrays["z_m"] = column(owner, count, &first.z_m);
  arrays["rotation"] = column(owner, count, first.rotation.data(), 4);
  arrays["scale"] = column(owner, count, &first.scale);
  arrays["health"] = column(owner, count, &first.health);
  arrays["tint"] = column(owner, count, &first.tint);
  arrays["shape"] = column(owner, count, &first.shape);
  arrays["level"] = column(owner, count, &first.level);
  py::list names;
  for (const ThingShape& shape : things.shapes) names.append(to_text(shape.name));
  arrays["shapes"] = names;
  return arrays;
}

/// What a value says of itself as JSON: a report, a catalogue, the head of a scene.
py::object document(const Held& held) {
  const Value& value = held.value;
  if (value.is<kinds::Report>())
    return from_json(recipe::OrderedJson::parse(io::report_json(value.get<kinds::Report>())));
  if (value.is<kinds::Catalogue>()) return from_json(recipe::catalogue_json(value.get<kinds::Catalogue>()));
  if (value.is<kinds::Objects>()) return from_json(recipe::scene_head_json(value.get<kinds::Objects>()));
  throw InvalidArgument("value", "a " + value.kind().name + " is no document");
}

Held catalogue(const py::object& document) {
  const std::string text = to_json(document, "catalogue").dump(-1, ' ', false, recipe::Json::error_handler_t::replace);
  return {Value::of<kinds::Catalogue>(recipe::parse_catalogue(text, "catalogue")), true};
}

std::string page(const Held& held) { return io::report_html(held.value.get<kinds::Report>()); }

}  // namespace

void add_contents(py::module_& module) {
  module.def("features", features);
  module.def("drawing", drawing);
  module.def("network", network);
  module.def("instances", instances);
  module.def("document", document);
  module.def("catalogue", catalogue);
  module.def("page", page);
}

}  // namespace seamount::python
