#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/svg_read.h"
#include "seamount/io/vector.h"
#include "seamount/io/vector_collect.h"
#include "seamount/io/vector_frame.h"
#include "seamount/io/vector_heights.h"
#include "seamount/io/vector_layers.h"
#include "seamount/io/vector_open.h"
#include "seamount/io/vector_place.h"

namespace seamount::io {
namespace {

/// Index of the field with the names of features; -1 if there is none.
int name_field(const OGRFeatureDefn& definition) {
  for (int i = 0; i < definition.GetFieldCount(); ++i)
    if (lower_case(definition.GetFieldDefn(i)->GetNameRef()) == "name") return i;
  for (int i = 0; i < definition.GetFieldCount(); ++i)
    if (definition.GetFieldDefn(i)->GetType() == OFTString) return i;
  return -1;
}

std::string field_text(const OGRFeature& feature, int field) {
  return field >= 0 && feature.IsFieldSetAndNotNull(field) != 0 ? feature.GetFieldAsString(field) : "";
}

/// A text that stands for a switch, as QGIS and people write them.
std::optional<double> switch_value(const std::string& text) {
  const std::string lower = lower_case(text);
  if (lower == "true" || lower == "yes" || lower == "y" || lower == "t") return 1.0;
  if (lower == "false" || lower == "no" || lower == "n" || lower == "f") return 0.0;
  return std::nullopt;
}

/// The numbers of a feature but for the one at `value_at`, which is its value.
Attributes field_numbers(const OGRFeature& feature, int value_at) {
  Attributes attributes;
  for (int i = 0; i < feature.GetFieldCount(); ++i) {
    const OGRFieldDefn& field = *feature.GetFieldDefnRef(i);
    const OGRFieldType type = field.GetType();
    if (i == value_at || feature.IsFieldSetAndNotNull(i) == 0) continue;
    if (type == OFTString) {
      if (const auto on = switch_value(feature.GetFieldAsString(i))) attributes.push_back({field.GetNameRef(), *on});
    } else if (type == OFTReal || type == OFTInteger || type == OFTInteger64) {
      const double number = feature.GetFieldAsDouble(i);
      if (std::isfinite(number)) attributes.push_back({field.GetNameRef(), number});
    }
  }
  return attributes;
}

/// The first of the fields that some feature has a height in; the first of all where none has.
std::optional<HeightField> choose_height_field(OGRLayer& layer, const std::vector<HeightField>& fields) {
  constexpr int kMostFeatures = 1000;
  if (fields.empty()) return std::nullopt;
  if (fields.size() == 1) return fields[0];
  std::vector<char> filled(fields.size(), 0);
  layer.ResetReading();
  for (int i = 0; i < kMostFeatures && filled[0] == 0; ++i) {
    const OGRFeatureUniquePtr feature{layer.GetNextFeature()};
    if (!feature) break;
    for (size_t f = 0; f < fields.size(); ++f)
      if (height_in(*feature, fields[f])) filled[f] = 1;
  }
  const auto first = std::find(filled.begin(), filled.end(), 1);
  return fields[first == filled.end() ? 0 : static_cast<size_t>(first - filled.begin())];
}

/// What an area's height is called among its attributes: what only may be a height keeps its name.
std::string area_height_name(const std::string& field, bool asked_for) {
  const std::string lower = lower_case(field);
  const bool vague = lower == "value" || lower == "level" || lower == "z" || lower == "niveau" || lower == "nivel";
  return vague && !asked_for ? field : "height_m";
}

/// What is read of a file: the names of its features, for suggestions, and whether the wanted one is among them.
struct Reading {
  Collector collector;
  std::vector<std::string> names;
  bool found = false;
  bool heights = false;
};

void say_field(const HeightField& field, const GdalCall& call, const RunContext& run) {
  if (field.name == "height_m" || field.name == "value") return;
  std::string unit;
  if (std::abs(field.unit_m - 1.0) > 1e-9)
    unit =
        field.unit_m > 0.3 && field.unit_m < 0.31 ? ", in feet" : ", in units of " + format_number(field.unit_m) + " m";
  run.say(call.path() + ": heights are taken from the field '" + field.name + "'" + unit);
}

double z_unit(OGRLayer& layer) {
  const OGRSpatialReference* system = layer.GetSpatialRef();
  if (system == nullptr || system->IsCompound() == 0) return 1.0;
  const double unit = system->GetTargetLinearUnits("VERT_CS");
  return unit > 0.0 ? unit : 1.0;
}

void read_layer(OGRLayer& layer, const VectorOptions& options, const GdalCall& call, const RunContext& run,
                Reading& reading) {
  constexpr size_t kMostNames = 10000;
  const OGRFeatureDefn& definition = *layer.GetLayerDefn();
  const int name_at = name_field(definition);
  const auto height = choose_height_field(layer, height_fields(definition, options.height_field, call));
  const int value_at = height ? height->index : -1;
  reading.collector.set_rules(
      {options.heights, z_unit(layer), field_list(definition), height ? height->name : std::string()});
  bool used = false;
  layer.ResetReading();
  while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) {
    run.check_cancelled();
    const std::string name = field_text(*feature, name_at);
    if (!name.empty() && reading.names.size() < kMostNames) reading.names.push_back(name);
    if (!options.feature.empty() && lower_case(name) != lower_case(options.feature)) continue;
    reading.found = true;
    const std::optional<double> value = height ? height_in(*feature, *height) : std::nullopt;
    used = used || value;
    const Attributes numbers = field_numbers(*feature, value_at);
    NamedArea area{name, {}, {}};
    if (value) area.attributes.push_back({area_height_name(height->name, !options.height_field.empty()), *value});
    area.attributes.insert(area.attributes.end(), numbers.begin(), numbers.end());
    reading.collector.begin({value, numbers}, feature->GetFID());
    if (const OGRGeometry* geometry = feature->GetGeometryRef()) reading.collector.add(*geometry, area);
    if (!area.parts.empty()) reading.collector.drawing().areas.push_back(std::move(area));
  }
  if (used) say_field(*height, call, run);
  reading.heights |= used && (options.heights || lower_case(height->name) == "height_m");
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
    if (frame && !frame->crs.empty()) {
      const auto system = parse_crs(frame->crs);
      if (system->IsGeographic() != 0 || std::abs(system->GetLinearUnits(nullptr) - 1.0) > 1e-9)
        throw InvalidArgument("seamount", "has a crs that is not in metres");
    }
    return frame;
  } catch (const InvalidArgument& error) {
    call.fail(error.what());
  }
}

void check_found(const Drawing& drawing, const GdalCall& call) {
  if (drawing.areas.empty() && drawing.lines.empty() && drawing.points.empty())
    call.fail("has no areas, lines or points in it");
}

SheetLines read_dataset(const std::string& place, const GdalCall& call, const VectorOptions& options,
                        const RunContext& run) {
  const DatasetPtr dataset = open_vector(place, call, run);
  Reading reading{Collector(call), {}, false, false};
  const std::vector<OGRLayer*> layers = choose_layers(*dataset, options, call, run);
  for (OGRLayer* layer : layers) read_layer(*layer, options, call, run, reading);
  run.check_cancelled();
  call.check("is damaged");
  if (!reading.found && !options.feature.empty())
    call.fail("has no feature '" + options.feature + "'" + suggestion(options.feature, reading.names));
  SheetLines read{std::move(reading.collector.drawing()), {}};
  Drawing& drawing = read.drawing;
  if (options.heights && reading.collector.z_is_level())
    call.fail(
        "its lines have no heights: no field is named like one and every z is 0; 'height_field' names the field "
        "(fields: " +
        field_list(*layers[0]->GetLayerDefn()) + ")");
  drawing.heights = reading.heights || (options.heights && reading.collector.has_z());
  check_found(drawing, call);
  drawing.frame = find_frame(*dataset, place, call);
  const bool geojson = std::string_view(dataset->GetDriverName()) == "GeoJSON";
  read.sheet = bring_to_metres(drawing, {layers[0]->GetSpatialRef(), geojson, options.crs}, call, run);
  if (drawing.frame) drawing.frame->crs = drawing.crs;
  return read;
}

SheetLines finish_svg(SvgDrawing svg, const GdalCall& call, const VectorOptions& options, const RunContext& run) {
  SheetLines read{std::move(svg.drawing), {}};
  Drawing& drawing = read.drawing;
  if (!options.feature.empty()) {
    std::vector<std::string> names;
    for (const NamedArea& area : drawing.areas) names.push_back(area.name);
    std::erase_if(drawing.areas,
                  [&](const NamedArea& area) { return lower_case(area.name) != lower_case(options.feature); });
    if (drawing.areas.empty())
      call.fail("has no feature '" + options.feature + "'" + suggestion(options.feature, names));
    drawing.lines.clear(), drawing.points.clear();
  }
  check_found(drawing, call);
  if (options.heights && svg.without_value)
    call.fail("its " + *svg.without_value + " has no height: give it the attribute data-height-m");
  const std::string stated = options.crs.empty() ? svg.crs : options.crs;
  if (!svg.ours && options.crs.empty())
    run.say(call.path() + ": its units are taken as metres, north up ('crs' states a system)");
  read.sheet = bring_to_metres(drawing, {nullptr, false, stated.empty() ? "local" : stated}, call, run);
  if (drawing.frame) drawing.frame->crs = drawing.crs;
  return read;
}

SheetLines read_file_lines(const std::string& path, const VectorOptions& options, const RunContext& run) {
  check_readable(path);
  check_vector_extension(path);
  const GdalCall call(path);
  if (extension_of(path) != ".svg") return read_dataset(path, call, options, run);
  return finish_svg(parse_svg(read_file(path, kMostSvgBytes), path), call, options, run);
}

}  // namespace

Drawing read_drawing(const std::string& path, const VectorOptions& options, const RunContext& run) {
  return read_file_lines(path, options, run).drawing;
}

Drawing read_geojson(std::span<const uint8_t> bytes, const std::string& name, const VectorOptions& options,
                     const RunContext& run) {
  GdalCall call(name);
  const MemoryFile memory(bytes, "shapes.geojson");
  call.hide(memory.path());
  return read_dataset(memory.path(), call, options, run).drawing;
}

Drawing read_svg(std::span<const uint8_t> bytes, const std::string& name, const VectorOptions& options,
                 const RunContext& run) {
  const GdalCall call(name);
  return finish_svg(parse_svg(bytes, name), call, options, run).drawing;
}

SheetLines read_contour_lines(const std::string& path, VectorOptions options, const RunContext& run) {
  options.heights = true;
  options.wanted = WantedShapes::lines;
  SheetLines read = read_file_lines(path, options, run);
  if (read.drawing.lines.empty()) throw IoError(path, "has no lines in it");
  return read;
}

Drawing read_areas(const std::string& path, VectorOptions options, const RunContext& run) {
  options.wanted = WantedShapes::areas;
  Drawing drawing = read_drawing(path, options, run);
  if (drawing.areas.empty() && drawing.lines.empty()) throw IoError(path, "has no areas in it");
  return drawing;
}

}  // namespace seamount::io
