#include "seamount/recipe/value_bytes.h"

#include <array>
#include <istream>
#include <ostream>
#include <vector>

#include "seamount/recipe/value_stream.h"

namespace seamount::recipe {
namespace {

constexpr uint64_t kMagic = 0x31304d5354414d53ULL;  // "SMATSM01"

void write_frame(Writer& writer, const GridFrame& frame) {
  writer.plain(frame.width);
  writer.plain(frame.height);
  writer.plain(frame.cell_m);
  writer.plain(frame.west_m);
  writer.plain(frame.north_m);
  writer.text(frame.crs);
}

GridFrame read_frame(Reader& reader) {
  GridFrame frame;
  frame.width = reader.plain<int>();
  frame.height = reader.plain<int>();
  frame.cell_m = reader.plain<double>();
  frame.west_m = reader.plain<double>();
  frame.north_m = reader.plain<double>();
  frame.crs = reader.text();
  return frame;
}

template <class T>
void write_grid(Writer& writer, const Grid<T>& grid) {
  write_frame(writer, grid.frame());
  writer.raw(grid.data(), grid.size() * sizeof(T));
}

template <class T>
Grid<T> read_grid(Reader& reader) {
  const GridFrame frame = read_frame(reader);
  if (frame.width < 0 || frame.height < 0 || static_cast<uint64_t>(frame.cells()) * sizeof(T) > reader.left())
    throw Damaged();
  Grid<T> grid(frame);
  reader.raw(grid.data(), grid.size() * sizeof(T));
  return grid;
}

void write_attributes(Writer& writer, const Attributes& attributes) {
  writer.plain(static_cast<uint64_t>(attributes.size()));
  for (const Attribute& attribute : attributes) {
    writer.text(attribute.name);
    writer.plain(attribute.value);
  }
}

Attributes read_attributes(Reader& reader) {
  Attributes attributes(reader.count(16));
  for (Attribute& attribute : attributes) {
    attribute.name = reader.text();
    attribute.value = reader.plain<double>();
  }
  return attributes;
}

void write_drawing(Writer& writer, const Drawing& drawing) {
  writer.text(drawing.crs);
  writer.plain(static_cast<uint64_t>(drawing.areas.size()));
  for (const NamedArea& area : drawing.areas) {
    writer.text(area.name);
    writer.plain(static_cast<uint64_t>(area.parts.size()));
    for (const Polygon& part : area.parts) {
      writer.list(part.outer);
      writer.plain(static_cast<uint64_t>(part.holes.size()));
      for (const Ring& hole : part.holes) writer.list(hole);
    }
    write_attributes(writer, area.attributes);
  }
  writer.plain(static_cast<uint64_t>(drawing.lines.size()));
  for (const ValuedLine& line : drawing.lines) {
    writer.list(line.points);
    writer.plain(line.value);
    writer.plain(static_cast<uint8_t>(line.closed));
    write_attributes(writer, line.attributes);
  }
  writer.plain(static_cast<uint64_t>(drawing.points.size()));
  for (const ValuedPoint& point : drawing.points) {
    writer.plain(point.place);
    writer.plain(point.value);
    write_attributes(writer, point.attributes);
  }
  writer.plain(static_cast<uint8_t>((drawing.heights ? 1 : 0) | (drawing.frame ? 2 : 0)));
  if (drawing.frame) write_frame(writer, *drawing.frame);
}

Drawing read_drawing(Reader& reader) {
  Drawing drawing;
  drawing.crs = reader.text();
  drawing.areas.resize(reader.count(8));
  for (NamedArea& area : drawing.areas) {
    area.name = reader.text();
    area.parts.resize(reader.count(8));
    for (Polygon& part : area.parts) {
      part.outer = reader.list<Vec2>();
      part.holes.resize(reader.count(8));
      for (Ring& hole : part.holes) hole = reader.list<Vec2>();
    }
    area.attributes = read_attributes(reader);
  }
  drawing.lines.resize(reader.count(8));
  for (ValuedLine& line : drawing.lines) {
    line.points = reader.list<Vec2>();
    line.value = reader.plain<double>();
    line.closed = reader.plain<uint8_t>() != 0;
    line.attributes = read_attributes(reader);
  }
  drawing.points.resize(reader.count(8));
  for (ValuedPoint& point : drawing.points) {
    point.place = reader.plain<Vec2>();
    point.value = reader.plain<double>();
    point.attributes = read_attributes(reader);
  }
  const auto flags = reader.plain<uint8_t>();
  drawing.heights = (flags & 1) != 0;
  if ((flags & 2) != 0) drawing.frame = read_frame(reader);
  return drawing;
}

void write_tin(Writer& writer, const Tin& tin) {
  write_frame(writer, tin.frame);
  writer.list(tin.nodes);
  writer.list(tin.triangles);
  writer.plain(static_cast<uint64_t>(tin.regions.size()));
  for (const TinRegion& region : tin.regions) {
    writer.text(region.name);
    writer.plain(region.parent);
    writer.list(region.outline);
    writer.plain(static_cast<uint8_t>(region.height_m.has_value()));
    writer.plain(region.height_m.value_or(0.0));
    writer.plain(static_cast<uint8_t>(region.basin));
    writer.plain(static_cast<uint8_t>(region.peak_m.has_value()));
    writer.plain(region.peak_m.value_or(0.0));
  }
  writer.list(tin.region);
  writer.list(tin.rank);
  writer.list(tin.bed_m);
  writer.list(tin.height_m);
}

Tin read_tin(Reader& reader) {
  Tin tin;
  tin.frame = read_frame(reader);
  tin.nodes = reader.list<Vec2>();
  tin.triangles = reader.list<std::array<int32_t, 3>>();
  tin.regions.resize(reader.count(8));
  for (TinRegion& region : tin.regions) {
    region.name = reader.text();
    region.parent = reader.plain<int>();
    region.outline = reader.list<Vec2>();
    const bool has_height = reader.plain<uint8_t>() != 0;
    const auto height = reader.plain<double>();
    if (has_height) region.height_m = height;
    region.basin = reader.plain<uint8_t>() != 0;
    const bool has_peak = reader.plain<uint8_t>() != 0;
    const auto peak = reader.plain<double>();
    if (has_peak) region.peak_m = peak;
  }
  tin.region = reader.list<int32_t>();
  tin.rank = reader.list<float>();
  tin.bed_m = reader.list<float>();
  tin.height_m = reader.list<float>();
  return tin;
}

void write_contours(Writer& writer, const ContourSet& set) {
  write_frame(writer, set.frame);
  writer.plain(static_cast<uint64_t>(set.contours.size()));
  for (const Contour& contour : set.contours) {
    writer.plain(contour.height_m);
    writer.list(contour.ring);
    writer.plain(contour.parent);
  }
}

ContourSet read_contours(Reader& reader) {
  ContourSet set;
  set.frame = read_frame(reader);
  set.contours.resize(reader.count(8));
  for (Contour& contour : set.contours) {
    contour.height_m = reader.plain<double>();
    contour.ring = reader.list<Vec2>();
    contour.parent = reader.plain<int>();
  }
  return set;
}

void write_plot(Writer& writer, const Plot& plot) {
  writer.plain(static_cast<uint8_t>(plot.kind));
  writer.text(plot.x_title);
  writer.text(plot.y_title);
  writer.plain(static_cast<uint8_t>(plot.log_x));
  writer.plain(static_cast<uint8_t>(plot.log_y));
  writer.plain(static_cast<uint64_t>(plot.lines.size()));
  for (const PlotLine& line : plot.lines) {
    writer.list(line.x);
    writer.list(line.y);
  }
}

Plot read_plot(Reader& reader) {
  Plot plot;
  const auto kind = reader.plain<uint8_t>();
  if (kind > static_cast<uint8_t>(PlotKind::bars)) throw Damaged();
  plot.kind = static_cast<PlotKind>(kind);
  plot.x_title = reader.text();
  plot.y_title = reader.text();
  plot.log_x = reader.plain<uint8_t>() != 0;
  plot.log_y = reader.plain<uint8_t>() != 0;
  plot.lines.resize(reader.count(16));
  for (PlotLine& line : plot.lines) {
    line.x = reader.list<double>();
    line.y = reader.list<double>();
  }
  return plot;
}

void write_measures(Writer& writer, const std::vector<Measure>& measures) {
  writer.plain(static_cast<uint64_t>(measures.size()));
  for (const Measure& measure : measures) {
    writer.text(measure.name);
    writer.text(measure.unit);
    writer.list(measure.values);
  }
}

std::vector<Measure> read_measures(Reader& reader) {
  std::vector<Measure> measures(reader.count(24));
  for (Measure& measure : measures) {
    measure.name = reader.text();
    measure.unit = reader.text();
    measure.values = reader.list<double>();
  }
  return measures;
}

void write_report(Writer& writer, const Report& report) {
  writer.text(report.title);
  writer.plain(static_cast<uint64_t>(report.subjects.size()));
  for (const std::string& subject : report.subjects) writer.text(subject);
  write_measures(writer, report.settings);
  writer.plain(static_cast<uint64_t>(report.descriptors.size()));
  for (const Descriptor& descriptor : report.descriptors) {
    writer.text(descriptor.name);
    writer.text(descriptor.title);
    writer.text(descriptor.meaning);
    write_plot(writer, descriptor.plot);
    write_measures(writer, descriptor.measures);
    writer.plain(static_cast<uint8_t>(descriptor.distance.has_value()));
    writer.plain(descriptor.distance.value_or(0.0));
  }
}

Report read_report(Reader& reader) {
  Report report;
  report.title = reader.text();
  report.subjects.resize(reader.count(8));
  for (std::string& subject : report.subjects) subject = reader.text();
  report.settings = read_measures(reader);
  report.descriptors.resize(reader.count(64));
  for (Descriptor& descriptor : report.descriptors) {
    descriptor.name = reader.text();
    descriptor.title = reader.text();
    descriptor.meaning = reader.text();
    descriptor.plot = read_plot(reader);
    descriptor.measures = read_measures(reader);
    const bool has_distance = reader.plain<uint8_t>() != 0;
    const auto distance = reader.plain<double>();
    if (has_distance) descriptor.distance = distance;
  }
  return report;
}

void write_value(Writer& writer, const Value& value) {
  writer.plain(static_cast<uint8_t>(value.kind()));
  switch (value.kind()) {
    case ValueKind::terrain:
    case ValueKind::field:
      return write_grid(writer, value.heights());
    case ValueKind::labels:
      return write_grid(writer, value.regions());
    case ValueKind::image:
      writer.plain(value.picture().width);
      writer.plain(value.picture().height);
      return writer.list(value.picture().rgb);
    case ValueKind::drawing:
      return write_drawing(writer, value.shapes());
    case ValueKind::tin:
      return write_tin(writer, value.network());
    case ValueKind::contours:
      return write_contours(writer, value.contour_set());
    case ValueKind::report:
      return write_report(writer, value.measured());
  }
}

Value read_value(Reader& reader) {
  switch (static_cast<ValueKind>(reader.plain<uint8_t>())) {
    case ValueKind::terrain:
      return Value::terrain(read_grid<float>(reader));
    case ValueKind::field:
      return Value::field(read_grid<float>(reader));
    case ValueKind::labels:
      return Value::labels(read_grid<Region>(reader));
    case ValueKind::image: {
      Image image;
      image.width = reader.plain<int>();
      image.height = reader.plain<int>();
      image.rgb = reader.list<uint8_t>();
      return Value::image(std::move(image));
    }
    case ValueKind::drawing:
      return Value::drawing(read_drawing(reader));
    case ValueKind::tin:
      return Value::tin(read_tin(reader));
    case ValueKind::contours:
      return Value::contours(read_contours(reader));
    case ValueKind::report:
      return Value::report(read_report(reader));
  }
  throw Damaged();
}

}  // namespace

void write_values(std::ostream& out, const Values& values) {
  Writer writer(out);
  writer.plain(kMagic);
  writer.plain(static_cast<uint64_t>(values.size()));
  for (const auto& [name, value] : values) {
    writer.text(name);
    write_value(writer, value);
  }
  writer.finish();
}

std::optional<Values> read_values(std::istream& in) {
  try {
    Reader reader(in);
    if (reader.plain<uint64_t>() != kMagic) return std::nullopt;
    Values values;
    const uint64_t count = reader.count(8);
    for (uint64_t i = 0; i < count; ++i) {
      std::string name = reader.text();
      values.insert_or_assign(std::move(name), read_value(reader));
    }
    reader.finish();
    return values;
  } catch (const Damaged&) {
    return std::nullopt;
  }
}

}  // namespace seamount::recipe
