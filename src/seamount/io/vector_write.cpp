#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/geopackage_write.h"
#include "seamount/io/projection.h"
#include "seamount/io/vector.h"
#include "seamount/io/vector_chains.h"
#include "seamount/io/vector_frame.h"

namespace seamount::io {
namespace {

double signed_area(const Ring& ring) {
  double sum = 0;
  for (size_t i = 0; i < ring.size(); ++i) sum += cross(ring[i], ring[(i + 1) % ring.size()]);
  return 0.5 * sum;
}

/// Counter-clockwise or not, without repeating the first point.
Ring oriented(Ring ring, bool counter_clockwise) {
  if ((signed_area(ring) > 0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
  return ring;
}

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Names of the attributes of a kind of feature, in order of appearance.
template <class Feature>
std::vector<std::string> attribute_names(const std::vector<Feature>& features) {
  std::vector<std::string> names;
  for (const Feature& feature : features)
    for (const Attribute& attribute : feature.attributes)
      if (std::find(names.begin(), names.end(), attribute.name) == names.end()) names.push_back(attribute.name);
  return names;
}

/// The same drawing in longitude and latitude, all points at once because a transformation is dear to set up.
Drawing in_degrees(Drawing drawing) {
  std::vector<Vec2> all;
  for_each_chain(drawing, [&](const std::vector<Vec2>& chain) { all.insert(all.end(), chain.begin(), chain.end()); });
  for (const ValuedPoint& point : drawing.points) all.push_back(point.place);
  all = to_lonlat(all, drawing.crs);
  auto next = all.begin();
  for_each_chain(drawing, [&](std::vector<Vec2>& chain) {
    // Across the 180th meridian longitudes go on beyond 180 instead of jumping to the other side of the map.
    const double first = next->x;
    for (Vec2& p : chain) {
      p = *next++;
      p.x -= 360.0 * std::round((p.x - first) / 360.0);
    }
  });
  for (ValuedPoint& point : drawing.points) point.place = *next++;
  return drawing;
}

/// What the values of lines and points are called in files.
const char* value_name(const Drawing& drawing) { return drawing.heights ? "height_m" : "value"; }

/// "[x,y]", or "[x,y,z]" with the height that goes before the bracket.
void append_point(std::string& text, Vec2 p, int digits, const std::string& height = "") {
  text += '[';
  append_decimal(text, p.x, digits);
  text += ',';
  append_decimal(text, p.y, digits);
  text += height;
  text += ']';
}

/// "[[x,y],...]".
void append_points(std::string& text, const std::vector<Vec2>& points, bool close, int digits,
                   const std::string& height = "") {
  text += '[';
  for (size_t i = 0; i < points.size() + (close ? 1 : 0); ++i) {
    if (i > 0) text += ',';
    append_point(text, points[i % points.size()], digits, height);
  }
  text += ']';
}

std::string to_geojson(const Drawing& metres) {
  const bool placed = !metres.crs.empty();
  const Drawing drawing = placed ? in_degrees(metres) : metres;
  const int digits = placed ? 10 : 6;  // a hundredth of a millimetre, a thousandth
  std::string text = "{\"type\":\"FeatureCollection\",";
  if (!placed) text += "\"crs\":{\"type\":\"name\",\"properties\":{\"name\":" + quoted(kLocalMetres) + "}},";
  if (drawing.frame) text += frame_member(*drawing.frame) + ",";
  text += "\"features\":[";
  const char* separator = "\n";
  const auto begin = [&](std::string properties, const Attributes& attributes, const char* type) {
    for (const Attribute& attribute : attributes)
      properties += "," + quoted(attribute.name) + ":" + format_number(attribute.value);
    text += separator;
    separator = ",\n";
    text += "{\"type\":\"Feature\",\"properties\":{" + properties + "},\"geometry\":{\"type\":\"" + type +
            "\",\"coordinates\":";
  };
  const std::string value_key = std::string("\"") + value_name(drawing) + "\":";
  const auto z = [&](double value) { return drawing.heights ? "," + format_number(value) : std::string(); };
  for (const NamedArea& area : drawing.areas) {
    begin("\"name\":" + quoted(area.name), area.attributes, "MultiPolygon");
    text += '[';
    for (size_t i = 0; i < area.parts.size(); ++i) {
      text += i == 0 ? "[" : ",[";
      append_points(text, oriented(area.parts[i].outer, true), true, digits);
      for (const Ring& hole : area.parts[i].holes) {
        text += ',';
        append_points(text, oriented(hole, false), true, digits);
      }
      text += ']';
    }
    text += "]}}";
  }
  for (const ValuedLine& line : drawing.lines) {
    begin(value_key + format_number(line.value), line.attributes, "LineString");
    append_points(text, line.points, line.closed, digits, z(line.value));
    text += "}}";
  }
  for (const ValuedPoint& point : drawing.points) {
    begin(value_key + format_number(point.value), point.attributes, "Point");
    append_point(text, point.place, digits, z(point.value));
    text += "}}";
  }
  return text + "\n]}\n";
}

void add_points(OGRSimpleCurve& curve, const std::vector<Vec2>& points, bool close) {
  for (const Vec2& p : points) curve.addPoint(p.x, p.y);
  if (close && !points.empty()) curve.addPoint(points.front().x, points.front().y);
}

void add_points_at(OGRSimpleCurve& curve, const std::vector<Vec2>& points, bool close, double z) {
  for (const Vec2& p : points) curve.addPoint(p.x, p.y, z);
  if (close && !points.empty()) curve.addPoint(points.front().x, points.front().y, z);
}

OGRLayer& add_layer(GDALDataset& dataset, const char* name, OGRwkbGeometryType type, const char* field,
                    OGRFieldType field_type, const std::vector<std::string>& numbers, OGRSpatialReference* system,
                    const GdalCall& call) {
  OGRLayer* layer = dataset.CreateLayer(name, system, type, nullptr);
  if (layer == nullptr) call.fail("cannot be written");
  const auto create = [&](const char* column, OGRFieldType column_type) {
    OGRFieldDefn definition(column, column_type);
    if (layer->CreateField(&definition) != OGRERR_NONE) call.fail("cannot be written");
  };
  create(field, field_type);
  for (const std::string& number : numbers) create(number.c_str(), OFTReal);
  return *layer;
}

void add_feature(OGRLayer& layer, OGRFeature& feature, const Attributes& attributes, const OGRGeometry& geometry,
                 const GdalCall& call) {
  for (const Attribute& attribute : attributes) feature.SetField(attribute.name.c_str(), attribute.value);
  feature.SetGeometry(&geometry);
  if (layer.CreateFeature(&feature) != OGRERR_NONE) call.fail("cannot be written");
}

void add_areas(GDALDataset& dataset, const Drawing& drawing, OGRSpatialReference* system, const GdalCall& call) {
  OGRLayer& layer =
      add_layer(dataset, "areas", wkbMultiPolygon, "name", OFTString, attribute_names(drawing.areas), system, call);
  for (const NamedArea& area : drawing.areas) {
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField("name", area.name.c_str());
    OGRMultiPolygon geometry;
    for (const Polygon& polygon : area.parts) {
      OGRPolygon part;
      OGRLinearRing ring;
      add_points(ring, polygon.outer, true);
      part.addRing(&ring);
      for (const Ring& hole : polygon.holes) {
        OGRLinearRing inner;
        add_points(inner, hole, true);
        part.addRing(&inner);
      }
      geometry.addGeometry(&part);
    }
    add_feature(layer, feature, area.attributes, geometry, call);
  }
}

void add_lines(GDALDataset& dataset, const Drawing& drawing, OGRSpatialReference* system, const GdalCall& call) {
  OGRLayer& layer = add_layer(dataset, "lines", drawing.heights ? wkbLineString25D : wkbLineString, value_name(drawing),
                              OFTReal, attribute_names(drawing.lines), system, call);
  for (const ValuedLine& line : drawing.lines) {
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField(value_name(drawing), line.value);
    OGRLineString geometry;
    if (drawing.heights)
      add_points_at(geometry, line.points, line.closed, line.value);
    else
      add_points(geometry, line.points, line.closed);
    add_feature(layer, feature, line.attributes, geometry, call);
  }
}

void add_places(GDALDataset& dataset, const Drawing& drawing, OGRSpatialReference* system, const GdalCall& call) {
  OGRLayer& layer = add_layer(dataset, "points", drawing.heights ? wkbPoint25D : wkbPoint, value_name(drawing), OFTReal,
                              attribute_names(drawing.points), system, call);
  for (const ValuedPoint& point : drawing.points) {
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField(value_name(drawing), point.value);
    const Vec2 p = point.place;
    const OGRPoint geometry = drawing.heights ? OGRPoint(p.x, p.y, point.value) : OGRPoint(p.x, p.y);
    add_feature(layer, feature, point.attributes, geometry, call);
  }
}

/// Every number of a drawing is finite and every chain has points.
void check_drawing(const Drawing& drawing) {
  const auto check_place = [](Vec2 p) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw InvalidArgument("drawing", "has a place that is not finite");
  };
  const auto check_numbers = [](const Attributes& attributes) {
    for (const Attribute& attribute : attributes)
      if (!std::isfinite(attribute.value))
        throw InvalidArgument("drawing", "has an attribute '" + attribute.name + "' that is not finite");
  };
  for_each_chain(drawing, [&](const std::vector<Vec2>& chain) {
    if (chain.empty()) throw InvalidArgument("drawing", "has a line or a ring without points");
    std::for_each(chain.begin(), chain.end(), check_place);
  });
  for (const NamedArea& area : drawing.areas) check_numbers(area.attributes);
  for (const ValuedLine& line : drawing.lines) {
    if (!std::isfinite(line.value)) throw InvalidArgument("drawing", "has a line whose value is not finite");
    check_numbers(line.attributes);
  }
  for (const ValuedPoint& point : drawing.points) {
    check_place(point.place);
    if (!std::isfinite(point.value)) throw InvalidArgument("drawing", "has a point whose value is not finite");
    check_numbers(point.attributes);
  }
}

void write_geopackage(const Drawing& drawing, const std::string& path) {
  write_new_geopackage(path, drawing.crs, [&](GDALDataset& dataset, OGRSpatialReference& system, const GdalCall& call) {
    if (!drawing.areas.empty()) add_areas(dataset, drawing, &system, call);
    if (!drawing.lines.empty()) add_lines(dataset, drawing, &system, call);
    if (!drawing.points.empty()) add_places(dataset, drawing, &system, call);
    if (drawing.frame && dataset.SetMetadataItem(kFrameItem, frame_text(*drawing.frame).c_str()) != CE_None)
      call.fail("cannot be written");
  });
}

}  // namespace

void write_drawing(const Drawing& drawing, const std::string& path) {
  check_drawing(drawing);
  const std::string extension = extension_of(path);
  if (extension == ".geojson" || extension == ".json") return write_text(path, to_geojson(drawing));
  if (extension == ".svg") return write_text(path, to_svg(drawing));
  if (extension == ".gpkg") return write_geopackage(drawing, path);
  throw IoError(path, "'" + extension + "' is not a vector format" +
                          suggestion(extension, {".geojson", ".json", ".gpkg", ".svg"}));
}

}  // namespace seamount::io
