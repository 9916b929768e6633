#include <ogrsf_frmts.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/geopackage_write.h"
#include "seamount/io/object_fields.h"
#include "seamount/io/object_file.h"
#include "seamount/io/projection.h"

namespace seamount::io {
namespace {

using Json = nlohmann::json;

std::string hold_text(const Skeleton& skeleton) {
  std::string text;
  for (const float h : skeleton.hold) text += (text.empty() ? "" : " ") + format_number(h);
  return text;
}

Json coordinates(const Skeleton& skeleton, const std::vector<Vec2>& places, size_t first, double unit) {
  const auto rounded = [&](double v) { return unit > 0 ? std::round(v / unit) * unit : v; };
  const auto at = [&](size_t i) { return Json::array({rounded(places[first + i].x), rounded(places[first + i].y)}); };
  if (skeleton.kind == SkeletonKind::point) return at(0);
  Json line = Json::array();
  for (size_t i = 0; i < skeleton.points.size(); ++i) line.push_back(at(i));
  if (skeleton.kind == SkeletonKind::curve) return line;
  line.push_back(at(0));
  return Json::array({line});
}

std::string to_geojson(const ObjectFile& file) {
  std::vector<Vec2> places;
  for (const ObjectFeature& object : file.objects)
    places.insert(places.end(), object.skeleton.points.begin(), object.skeleton.points.end());
  const bool placed = !file.crs.empty();
  if (placed) places = to_lonlat(places, file.crs);
  Json root = {{"type", "FeatureCollection"}, {kSceneItem, file.head.empty() ? Json(nullptr) : Json::parse(file.head)}};
  if (!placed) root["crs"] = {{"type", "name"}, {"properties", {{"name", kLocalMetres}}}};
  root["seamount_crs"] = file.crs;
  Json& features = root["features"] = Json::array();
  constexpr std::array<const char*, 3> kTypes = {"Point", "LineString", "Polygon"};
  size_t first = 0;
  for (const ObjectFeature& object : file.objects) {
    Json properties = {{"class", object.of_class}, {"id", object.id},     {"size", object.size},
                       {"fitness", nullptr},       {"born", object.born}, {"age", object.age},
                       {"window", object.window},  {"keep", object.keep}};
    if (std::isfinite(object.fitness)) properties["fitness"] = object.fitness;
    if (!object.skeleton.hold.empty()) properties["hold"] = hold_text(object.skeleton);
    features.push_back({{"type", "Feature"},
                        {"properties", std::move(properties)},
                        {"geometry",
                         {{"type", kTypes[static_cast<size_t>(object.skeleton.kind)]},
                          {"coordinates", coordinates(object.skeleton, places, first, placed ? 1e-10 : 0.0)}}}});
    first += object.skeleton.points.size();
  }
  return root.dump() + "\n";
}

OGRLayer& add_layer(GDALDataset& dataset, const char* name, OGRwkbGeometryType type, OGRSpatialReference* system,
                    const GdalCall& call) {
  OGRLayer* layer = dataset.CreateLayer(name, system, type, nullptr);
  if (layer == nullptr) call.fail("cannot be written");
  constexpr std::array<std::pair<const char*, OGRFieldType>, 9> kFields = {{{"class", OFTString},
                                                                            {"id", OFTInteger64},
                                                                            {"size", OFTReal},
                                                                            {"fitness", OFTReal},
                                                                            {"born", OFTInteger},
                                                                            {"age", OFTInteger},
                                                                            {"window", OFTInteger},
                                                                            {"keep", OFTInteger},
                                                                            {"hold", OFTString}}};
  for (const auto& [field, field_type] : kFields) {
    OGRFieldDefn definition(field, field_type);
    if (layer->CreateField(&definition) != OGRERR_NONE) call.fail("cannot be written");
  }
  return *layer;
}

std::unique_ptr<OGRGeometry> geometry_of(const Skeleton& skeleton) {
  if (skeleton.kind == SkeletonKind::point)
    return std::make_unique<OGRPoint>(skeleton.points[0].x, skeleton.points[0].y);
  if (skeleton.kind == SkeletonKind::curve) {
    auto line = std::make_unique<OGRLineString>();
    for (const Vec2 p : skeleton.points) line->addPoint(p.x, p.y);
    return line;
  }
  OGRLinearRing ring;
  for (const Vec2 p : skeleton.points) ring.addPoint(p.x, p.y);
  ring.addPoint(skeleton.points[0].x, skeleton.points[0].y);
  auto area = std::make_unique<OGRPolygon>();
  area->addRing(&ring);
  return area;
}

void add_objects(GDALDataset& dataset, const ObjectFile& file, SkeletonKind kind, OGRSpatialReference* system,
                 const GdalCall& call) {
  constexpr std::array<const char*, 3> kNames = {"points", "curves", "regions"};
  constexpr std::array<OGRwkbGeometryType, 3> kTypes = {wkbPoint, wkbLineString, wkbPolygon};
  const auto k = static_cast<size_t>(kind);
  OGRLayer& layer = add_layer(dataset, kNames[k], kTypes[k], system, call);
  for (const ObjectFeature& object : file.objects) {
    if (object.skeleton.kind != kind) continue;
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField("class", object.of_class.c_str());
    feature.SetField("id", static_cast<GIntBig>(object.id));
    feature.SetField("size", object.size);
    if (std::isfinite(object.fitness)) feature.SetField("fitness", object.fitness);
    feature.SetField("born", object.born);
    feature.SetField("age", object.age);
    feature.SetField("window", object.window);
    feature.SetField("keep", object.keep ? 1 : 0);
    if (!object.skeleton.hold.empty()) feature.SetField("hold", hold_text(object.skeleton).c_str());
    feature.SetGeometryDirectly(geometry_of(object.skeleton).release());
    if (layer.CreateFeature(&feature) != OGRERR_NONE) call.fail("cannot be written");
  }
}

void write_geopackage(const ObjectFile& file, const std::string& path) {
  write_new_geopackage(path, file.crs, [&](GDALDataset& dataset, OGRSpatialReference& system, const GdalCall& call) {
    for (const SkeletonKind kind : {SkeletonKind::region, SkeletonKind::curve, SkeletonKind::point})
      add_objects(dataset, file, kind, &system, call);
    if (!file.head.empty() && dataset.SetMetadataItem(kSceneItem, file.head.c_str()) != CE_None)
      call.fail("cannot be written");
  });
}

}  // namespace

void write_objects(const ObjectFile& file, const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".geojson") return write_text(path, to_geojson(file));
  if (extension == ".gpkg") return write_geopackage(file, path);
  throw IoError(path, "'" + extension + "' is no format of objects" + suggestion(extension, {".geojson", ".gpkg"}));
}

}  // namespace seamount::io
