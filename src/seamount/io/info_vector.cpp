// What a file of areas, lines and points is, for people (info.h).
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>

#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/info.h"
#include "seamount/io/projection.h"
#include "seamount/io/svg_read.h"
#include "seamount/io/vector_chains.h"
#include "seamount/io/vector_heights.h"
#include "seamount/io/vector_layers.h"
#include "seamount/io/vector_open.h"
#include "seamount/io/vector_place.h"

namespace seamount::io {
namespace {

/// What is told of one layer.
struct LayerTale {
  size_t areas = 0, lines = 0, points = 0, without_shape = 0;
  OGREnvelope extent;
  std::string system;
  std::string unit;
  std::string fields;
  std::string heights;
  std::vector<std::string> names;
};

constexpr size_t kMostNames = 20;

void count_shapes(const OGRGeometry& geometry, LayerTale& tale, int depth = 0) {
  constexpr int kDeepest = 16;
  if (geometry.IsEmpty() != 0 || depth > kDeepest) return;
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) count_shapes(*part, tale, depth + 1);
    return;
  }
  ++(OGR_GT_IsSurface(type) != 0 ? tale.areas : OGR_GT_IsCurve(type) != 0 ? tale.lines : tale.points);
}

std::string field_types(const OGRFeatureDefn& definition) {
  constexpr int kMost = 40;
  std::string list;
  for (int i = 0; i < std::min(definition.GetFieldCount(), kMost); ++i) {
    const OGRFieldDefn& field = *definition.GetFieldDefn(i);
    const OGRFieldType type = field.GetType();
    const char* kind = type == OFTString                            ? "text"
                       : type == OFTInteger || type == OFTInteger64 ? "integer"
                       : type == OFTReal                            ? "real"
                                                                    : OGRFieldDefn::GetFieldTypeName(type);
    list += std::string(i == 0 ? "" : ", ") + field.GetNameRef() + " (" + kind + ")";
  }
  if (definition.GetFieldCount() > kMost) list += ", ...";
  return list.empty() ? "none" : list;
}

void tell_system(const OGRSpatialReference* system, LayerTale& tale) {
  tale.system = "none (local metres, or degrees by their size)";
  if (system != nullptr && system->IsLocal() != 0) tale.system = "none (local metres)";
  if (is_undefined(system)) return;
  const OGRSpatialReference own = identified(*system);
  const char* name = own.GetName();
  tale.system = name != nullptr ? name : crs_text(&own);
  const char* code = own.GetAuthorityCode(nullptr);
  if (code != nullptr) tale.system += " (" + crs_text(&own) + ")";
  const bool metric = std::abs(own.GetLinearUnits(nullptr) - 1.0) < 1e-9;
  tale.unit = own.IsGeographic() != 0 ? " degrees" : metric ? " m" : "";
}

int text_field(const OGRFeatureDefn& definition) {
  int first = -1;
  for (int i = 0; i < definition.GetFieldCount(); ++i) {
    if (lower_case(definition.GetFieldDefn(i)->GetNameRef()) == "name") return i;
    if (first < 0 && definition.GetFieldDefn(i)->GetType() == OFTString) first = i;
  }
  return first;
}

LayerTale tell_layer(OGRLayer& layer, const GdalCall& call) {
  LayerTale tale;
  const OGRFeatureDefn& definition = *layer.GetLayerDefn();
  tale.fields = field_types(definition);
  tell_system(layer.GetSpatialRef(), tale);
  const std::vector<HeightField> heights = height_fields(definition, "", call);
  const int name_at = text_field(definition);
  double low = INFINITY, high = -INFINITY;
  layer.ResetReading();
  while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) {
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (geometry == nullptr || geometry->IsEmpty() != 0) {
      ++tale.without_shape;
    } else {
      count_shapes(*geometry, tale);
      OGREnvelope box;
      geometry->getEnvelope(&box);
      tale.extent.Merge(box);
    }
    if (!heights.empty())
      if (const auto height = height_in(*feature, heights[0]))
        low = std::min(low, *height), high = std::max(high, *height);
    if (name_at >= 0 && tale.names.size() <= kMostNames && feature->IsFieldSetAndNotNull(name_at) != 0)
      tale.names.emplace_back(feature->GetFieldAsString(name_at));
  }
  call.check("is damaged");
  if (high >= low)
    tale.heights = short_number(low) + " m to " + short_number(high) + " m, in the field '" + heights[0].name + "'";
  return tale;
}

std::string shapes_of(const LayerTale& tale) {
  std::string text;
  const auto add = [&](size_t count, const char* one, const char* many) {
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + (count == 1 ? one : many);
  };
  add(tale.areas, "area", "areas");
  add(tale.lines, "line", "lines");
  add(tale.points, "point", "points");
  add(tale.without_shape, "feature without a shape", "features without a shape");
  return text.empty() ? "empty" : text;
}

std::string extent_of(const LayerTale& tale) {
  if (tale.extent.IsInit() == 0) return "nothing";
  const auto side = [&](const char* name, double low, double high) {
    const double unit = std::pow(10.0, std::floor(std::log10(std::max(high - low, 1e-9))) - 4.0);
    const auto rounded = [&](double value) {
      return format_number(unit < 1 ? std::round(value / unit) / std::round(1 / unit) : std::round(value));
    };
    return std::string(name) + " " + rounded(low) + " to " + rounded(high);
  };
  return side("x", tale.extent.MinX, tale.extent.MaxX) + ", " + side("y", tale.extent.MinY, tale.extent.MaxY) +
         tale.unit;
}

std::string names_of(const std::vector<std::string>& names) {
  std::string list;
  for (size_t i = 0; i < std::min(kMostNames, names.size()); ++i) list += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > kMostNames) list += ", ...";
  return list.empty() ? "without names" : list;
}

LayerTale tell_svg(const SvgDrawing& svg) {
  LayerTale tale;
  const Drawing& drawing = svg.drawing;
  for (const NamedArea& area : drawing.areas) tale.areas += area.parts.size();
  tale.lines = drawing.lines.size(), tale.points = drawing.points.size();
  for (const NamedArea& area : drawing.areas)
    if (!area.name.empty()) tale.names.push_back(area.name);
  for_each_chain(drawing, [&](const std::vector<Vec2>& points) {
    for (const Vec2 p : points) tale.extent.Merge(p.x, p.y);
  });
  for (const ValuedPoint& point : drawing.points) tale.extent.Merge(point.place.x, point.place.y);
  tale.system = svg.crs.empty() ? "none (local metres)" : crs_name(svg.crs);
  tale.unit = " m";
  tale.fields = "none";
  return tale;
}

void tell(FileInfo& info, const LayerTale& tale) {
  info.emplace_back("shapes", shapes_of(tale));
  info.emplace_back("coordinate system", tale.system);
  info.emplace_back("extent", extent_of(tale));
  info.emplace_back("fields", tale.fields);
  if (!tale.heights.empty()) info.emplace_back("heights", tale.heights);
  info.emplace_back("features", names_of(tale.names));
}

}  // namespace

std::optional<FileInfo> describe_vector(const std::string& path) {
  const std::string extension = extension_of(path);
  const std::vector<std::string> known = {".geojson", ".json", ".gpkg", ".shp", ".svg"};
  if (std::find(known.begin(), known.end(), extension) == known.end()) return std::nullopt;
  check_readable(path);
  if (extension == ".svg") {
    FileInfo info = {{"format", "SVG"}};
    tell(info, tell_svg(parse_svg(read_file(path, kMostSvgBytes), path)));
    return info;
  }
  const GdalCall call(path);
  const RunContext run;
  const DatasetPtr dataset = open_vector(path, call, run);
  const std::vector<OGRLayer*> layers = layers_of(*dataset);
  FileInfo info = {{"format", dataset->GetDriver()->GetMetadataItem(GDAL_DMD_LONGNAME)}};
  if (layers.size() == 1) {
    info.emplace_back("layer", layers[0]->GetName());
    tell(info, tell_layer(*layers[0], call));
    return info;
  }
  info.emplace_back("layers", std::to_string(layers.size()));
  for (OGRLayer* layer : layers) {
    const LayerTale tale = tell_layer(*layer, call);
    info.emplace_back("layer '" + std::string(layer->GetName()) + "'",
                      shapes_of(tale) + "; " + tale.system + "; " + extent_of(tale) + "; fields: " + tale.fields);
  }
  return info;
}

}  // namespace seamount::io
