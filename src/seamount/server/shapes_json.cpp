// Drawn things and models for the page: the rest of value_bytes.h.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "seamount/recipe/json_document.h"
#include "seamount/recipe/kinds.h"
#include "seamount/server/value_bytes.h"

namespace seamount::server {
namespace {

using recipe::Json;
namespace kinds = recipe::kinds;

Json place_json(Vec2 place) { return {place.x, place.y}; }

Json line_json(const Polyline& points, bool closed) {
  Json list = Json::array();
  for (const Vec2 point : points) list.push_back(place_json(point));
  if (closed && !points.empty()) list.push_back(place_json(points.front()));
  return list;
}

Json feature(const char* type, Json coordinates, Json properties) {
  return {{"type", "Feature"},
          {"geometry", {{"type", type}, {"coordinates", std::move(coordinates)}}},
          {"properties", std::move(properties)}};
}

Json attributes_json(const Attributes& attributes, Json properties) {
  for (const Attribute& attribute : attributes) properties[attribute.name] = attribute.value;
  return properties;
}

Json drawing_features(const Drawing& drawing) {
  Json list = Json::array();
  for (const NamedArea& area : drawing.areas) {
    Json parts = Json::array();
    for (const Polygon& part : area.parts) {
      Json rings = Json::array({line_json(part.outer, true)});
      for (const Ring& hole : part.holes) rings.push_back(line_json(hole, true));
      parts.push_back(std::move(rings));
    }
    list.push_back(feature("MultiPolygon", std::move(parts), attributes_json(area.attributes, {{"name", area.name}})));
  }
  for (const ValuedLine& line : drawing.lines)
    list.push_back(feature("LineString", line_json(line.points, line.closed),
                           attributes_json(line.attributes, {{"value", line.value}})));
  for (const ValuedPoint& point : drawing.points)
    list.push_back(
        feature("Point", place_json(point.place), attributes_json(point.attributes, {{"value", point.value}})));
  return list;
}

Json contour_features(const ContourSet& set) {
  Json list = Json::array();
  for (const Contour& contour : set.contours)
    list.push_back(feature("LineString", line_json(contour.ring, true), {{"value", contour.height_m}}));
  return list;
}

/// Each edge of a network once, as one set of lines.
Json network_features(const Tin& tin) {
  Json lines = Json::array();
  for (const auto& triangle : tin.triangles) {
    for (size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<size_t>(triangle[i]), b = static_cast<size_t>(triangle[(i + 1) % 3]);
      if (a < b) lines.push_back({place_json(tin.nodes[a]), place_json(tin.nodes[b])});
    }
  }
  return Json::array({feature("MultiLineString", std::move(lines), Json::object())});
}

Json object_features(const Scene& scene) {
  Json list = Json::array();
  for (const SceneObject& object : scene.objects) {
    const auto& of_class = scene.catalogue.classes[static_cast<size_t>(object.of_class)];
    Json properties = {{"id", object.id},           {"class", of_class.name}, {"size", object.size},
                       {"fitness", object.fitness}, {"born", object.born},    {"keep", object.keep}};
    const Polyline& points = object.skeleton.points;
    if (object.skeleton.kind == SkeletonKind::point && !points.empty()) {
      list.push_back(feature("Point", place_json(points.front()), std::move(properties)));
    } else {
      const bool closed = object.skeleton.kind == SkeletonKind::region;
      list.push_back(feature("LineString", line_json(points, closed), std::move(properties)));
    }
  }
  return list;
}

std::string base64(std::span<const float> values) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
  const size_t size = values.size_bytes();
  std::string text;
  text.reserve((size + 2) / 3 * 4);
  for (size_t i = 0; i < size; i += 3) {
    const unsigned triple = (unsigned{bytes[i]} << 16) | (i + 1 < size ? unsigned{bytes[i + 1]} << 8 : 0) |
                            (i + 2 < size ? unsigned{bytes[i + 2]} : 0);
    for (size_t digit = 0; digit < 4; ++digit)
      text += i + digit <= size ? kDigits[(triple >> (18 - 6 * digit)) & 63] : '=';
  }
  return text;
}

/// Position, normal and colour of each corner of each triangle: 9 numbers.
std::string triangles_text(const ThingMesh& mesh) {
  std::vector<float> numbers;
  numbers.reserve(9 * mesh.indices.size());
  for (const uint32_t index : mesh.indices) {
    const size_t at = size_t{3} * index;
    numbers.insert(numbers.end(), mesh.positions.begin() + static_cast<std::ptrdiff_t>(at),
                   mesh.positions.begin() + static_cast<std::ptrdiff_t>(at + 3));
    numbers.insert(numbers.end(), mesh.normals.begin() + static_cast<std::ptrdiff_t>(at),
                   mesh.normals.begin() + static_cast<std::ptrdiff_t>(at + 3));
    const Colour colour = mesh.colours[index];
    for (const unsigned char channel : {colour.r, colour.g, colour.b})
      numbers.push_back(static_cast<float>(channel) / 255.0F);
  }
  return base64(numbers);
}

/// The coarsest level that still looks like the thing.
const ThingMesh& level_to_draw(const ThingShape& shape) {
  constexpr size_t kFewest = 100;
  for (size_t i = shape.levels.size(); i-- > 1;) {
    if (shape.levels[i].triangle_count() >= kFewest) return shape.levels[i];
  }
  return shape.levels.front();
}

Json instance_json(const Thing& thing) {
  const auto ahead = turned(thing.rotation, {1, 0, 0});
  return {{"model", thing.shape},  {"x", thing.place.x},
          {"y", thing.place.y},    {"z", thing.z_m},
          {"scale", thing.scale},  {"angle_deg", std::atan2(ahead[1], ahead[0]) * 180 / std::numbers::pi},
          {"health", thing.health}};
}

}  // namespace

std::string shapes_json(const recipe::Value& value) {
  Json features;
  if (value.is<kinds::Drawing>()) {
    features = drawing_features(value.get<kinds::Drawing>());
  } else if (value.is<kinds::Contours>()) {
    features = contour_features(value.get<kinds::Contours>());
  } else if (value.is<kinds::Tin>()) {
    features = network_features(value.get<kinds::Tin>());
  } else if (value.is<kinds::Objects>()) {
    features = object_features(value.get<kinds::Objects>());
  } else {
    throw IncompatibleInputs(fmt::format("a result of the kind '{}' cannot be had as shapes", value.kind().name));
  }
  return Json{{"type", "FeatureCollection"}, {"features", std::move(features)}}.dump();
}

std::string things_json(const recipe::Value& value, size_t most) {
  if (!value.is<kinds::Things>())
    throw IncompatibleInputs(fmt::format("a result of the kind '{}' cannot be had as things", value.kind().name));
  const Things& things = value.get<kinds::Things>();
  Json models = Json::array(), instances = Json::array();
  for (const ThingShape& shape : things.shapes)
    models.push_back({{"name", shape.name}, {"triangles", triangles_text(level_to_draw(shape))}});
  std::vector<size_t> order(things.things.size());
  std::iota(order.begin(), order.end(), size_t{0});
  const auto size_of = [&](size_t i) {
    return things.shapes[things.things[i].shape].height_m * things.things[i].scale;
  };
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return size_of(a) > size_of(b); });
  order.resize(std::min(order.size(), most));
  for (const size_t i : order) instances.push_back(instance_json(things.things[i]));
  return Json{{"models", models}, {"instances", instances}, {"of", things.things.size()}}.dump();
}

}  // namespace seamount::server
