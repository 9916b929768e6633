#include <ogrsf_frmts.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/object_fields.h"
#include "seamount/io/object_file.h"
#include "seamount/io/projection.h"
#include "seamount/io/vector_open.h"
#include "seamount/io/vector_place.h"

namespace seamount::io {
namespace {

constexpr uint64_t kLargestFile = uint64_t{256} << 20;

class ObjectReader {
 public:
  ObjectReader(ObjectFile& file, const GdalCall& call, const RunContext& run) : file_(file), call_(call), run_(run) {}

  void read(OGRLayer& layer) {
    const OGRFeatureDefn& definition = *layer.GetLayerDefn();
    if (definition.GetFieldIndex("class") < 0)
      call_.fail("the layer '" + std::string(layer.GetName()) + "' has no field \"class\"");
    layer.ResetReading();
    while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) {
      run_.check_cancelled();
      ObjectFeature object;
      object.of_class = feature->GetFieldAsString("class");
      object.id = static_cast<uint64_t>(std::max<GIntBig>(0, number(*feature, "id", 0)));
      object.size = real(*feature, "size", 1.0);
      object.fitness = real(*feature, "fitness", 0.0);
      object.born = static_cast<int>(number(*feature, "born", 0));
      object.window = static_cast<int>(number(*feature, "window", 0));
      object.keep = number(*feature, "keep", 0) != 0;
      const std::vector<float> hold = hold_of(*feature);
      if (const OGRGeometry* geometry = feature->GetGeometryRef()) add(*geometry, std::move(object), hold, 0);
    }
  }

 private:
  static int field(const OGRFeature& feature, const char* name) {
    const int index = feature.GetFieldIndex(name);
    return index >= 0 && feature.IsFieldSetAndNotNull(index) != 0 ? index : -1;
  }
  static GIntBig number(const OGRFeature& feature, const char* name, GIntBig otherwise) {
    const int index = field(feature, name);
    return index < 0 ? otherwise : feature.GetFieldAsInteger64(index);
  }
  static double real(const OGRFeature& feature, const char* name, double otherwise) {
    const int index = field(feature, name);
    return index < 0 ? otherwise : feature.GetFieldAsDouble(index);
  }

  std::vector<float> hold_of(const OGRFeature& feature) const {
    const int index = field(feature, "hold");
    std::vector<float> hold;
    if (index < 0) return hold;
    const std::string text = feature.GetFieldAsString(index);
    const char* at = text.data();
    const char* end = at + text.size();
    while (at < end) {
      float value = 0.0F;
      const auto [next, error] = std::from_chars(at, end, value);
      if (error != std::errc() || !(value >= 0 && value <= 1)) call_.fail("\"hold\" is no list of numbers from 0 to 1");
      hold.push_back(value);
      at = next;
      while (at < end && *at == ' ') ++at;
    }
    return hold;
  }

  void add(const OGRGeometry& geometry, ObjectFeature object, const std::vector<float>& hold, int depth) {
    constexpr int kDeepest = 16;
    if (depth > kDeepest) call_.fail("its collections are nested too deeply");
    if (geometry.IsEmpty() != 0) return;
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (type == wkbPoint) {
      object.skeleton = {SkeletonKind::point, {{geometry.toPoint()->getX(), geometry.toPoint()->getY()}}};
    } else if (type == wkbLineString) {
      object.skeleton = {SkeletonKind::curve, points_of(*geometry.toLineString())};
    } else if (type == wkbPolygon) {
      const OGRPolygon& area = *geometry.toPolygon();
      if (area.getNumInteriorRings() > 0) call_.fail("a region has a hole: objects have none");
      object.skeleton = {SkeletonKind::region, ring_of(*area.getExteriorRing())};
    } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0) {
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
        add(*part, object, hold, depth + 1);
        object.id = 0;  // of the first part alone
      }
      return;
    } else {
      call_.fail("has a geometry that is no point, line or area");
    }
    for (const Vec2 p : object.skeleton.points)
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) call_.fail("has a coordinate that is not finite");
    if (hold.size() == object.skeleton.points.size()) object.skeleton.hold = hold;
    file_.objects.push_back(std::move(object));
  }

  static Polyline points_of(const OGRSimpleCurve& curve) {
    Polyline points;
    for (int i = 0; i < curve.getNumPoints(); ++i) points.push_back({curve.getX(i), curve.getY(i)});
    return points;
  }
  /// Counter-clockwise, the first point not repeated.
  static Ring ring_of(const OGRLinearRing& from) {
    Ring ring = points_of(from);
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    double area = 0.0;
    for (size_t i = 0; i < ring.size(); ++i) area += cross(ring[i], ring[(i + 1) % ring.size()]);
    if (area < 0) std::reverse(ring.begin() + 1, ring.end());
    return ring;
  }

  ObjectFile& file_;
  const GdalCall& call_;
  const RunContext& run_;
};

/// The members beside the features of a GeoJSON file.
void read_members(const std::string& path, ObjectFile& file) {
  const std::vector<uint8_t> bytes = read_file(path, kLargestFile);
  const nlohmann::json root = nlohmann::json::parse(bytes.begin(), bytes.end(), nullptr, false);
  if (!root.is_object()) return;
  if (root.contains(kSceneItem) && root[kSceneItem].is_object()) file.head = root[kSceneItem].dump();
  if (root.contains("seamount_crs") && root["seamount_crs"].is_string()) file.crs = root["seamount_crs"];
}

/// From longitude and latitude back to the system that the objects were in, or to a local one.
void leave_degrees(ObjectFile& file) {
  std::vector<Vec2> places;
  for (const ObjectFeature& object : file.objects)
    places.insert(places.end(), object.skeleton.points.begin(), object.skeleton.points.end());
  if (places.empty()) return;
  if (file.crs.empty()) file.crs = local_crs(places[0].x, places[0].y);
  places = from_lonlat(places, file.crs);
  auto next = places.begin();
  for (ObjectFeature& object : file.objects)
    for (Vec2& p : object.skeleton.points) p = *next++;
}

}  // namespace

ObjectFile read_objects(const std::string& path, const RunContext& run) {
  const std::string extension = extension_of(path);
  if (extension != ".geojson" && extension != ".gpkg")
    throw IoError(path, "'" + extension + "' is no format of objects" + suggestion(extension, {".geojson", ".gpkg"}));
  check_readable(path);
  ObjectFile file;
  if (extension == ".geojson") read_members(path, file);
  const GdalCall call(path);
  const DatasetPtr dataset = open_vector(path, call, run);
  ObjectReader reader(file, call, run);
  bool degrees = false;
  std::string metres;
  for (int i = 0; i < dataset->GetLayerCount(); ++i) {
    OGRLayer& layer = *dataset->GetLayer(i);
    if (layer.GetFeatureCount() == 0) continue;
    const OGRSpatialReference* system = layer.GetSpatialRef();
    if (!is_undefined(system) && system->IsGeographic() != 0) degrees = true;
    if (!is_undefined(system) && system->IsGeographic() == 0) metres = metric_crs(crs_text(system));
    if (degrees && !metres.empty()) call.fail("some of its layers are in degrees, some in metres");
    reader.read(layer);
  }
  call.check("cannot be read");
  if (degrees) leave_degrees(file);
  if (!metres.empty()) file.crs = metres;
  if (extension == ".gpkg") {
    if (const char* head = dataset->GetMetadataItem(kSceneItem)) file.head = head;
  }
  return file;
}

bool has_scene(const std::string& path) {
  check_readable(path);
  try {
    if (extension_of(path) == ".geojson") {
      ObjectFile file;
      read_members(path, file);
      return !file.head.empty();
    }
    const GdalCall call(path);
    return open_vector(path, call, {})->GetMetadataItem(kSceneItem) != nullptr;
  } catch (const IoError&) {
    return false;
  }
}

}  // namespace seamount::io
