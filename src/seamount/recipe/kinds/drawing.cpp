// drawing: areas, lines and points, as people draw them and as GIS files hold them.
#include <algorithm>

#include "seamount/io/reproject.h"
#include "seamount/io/vector.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/frame_bytes.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

void write_drawing(Writer& writer, const seamount::Drawing& drawing) {
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

size_t size_of(const Drawing& drawing) {
  size_t points = drawing.points.size();
  for (const NamedArea& area : drawing.areas) {
    for (const Polygon& part : area.parts) {
      points += part.outer.size();
      for (const Ring& hole : part.holes) points += hole.size();
    }
  }
  for (const ValuedLine& line : drawing.lines) points += line.points.size();
  return points * sizeof(Vec2);
}

std::optional<Extent> extent_of(const Drawing& drawing) {
  std::optional<Extent> extent;
  const auto add = [&](Vec2 p) {
    const Extent place{drawing.crs, p.x, p.y, p.x, p.y};
    if (extent)
      extent->include(place);
    else
      extent = place;
  };
  for (const NamedArea& area : drawing.areas)
    for (const Polygon& part : area.parts) std::for_each(part.outer.begin(), part.outer.end(), add);
  for (const ValuedLine& line : drawing.lines) std::for_each(line.points.begin(), line.points.end(), add);
  for (const ValuedPoint& point : drawing.points) add(point.place);
  return extent;
}

}  // namespace

const Kind& kinds::Drawing::kind() {
  static const Kind kind = make_kind<seamount::Drawing>({
      .name = "drawing",
      .about = "areas, lines and points",
      .files = {".geojson"},
      .reads = {".geojson", ".json", ".gpkg", ".shp", ".svg"},
      .frame = {},
      .extent = extent_of,
      .bring = [](const seamount::Drawing& drawing,
                  const Destination& to) { return io::in_system(drawing, to.frame.crs); },
      .bytes = size_of,
      .write = write_drawing,
      .read = read_drawing,
      .read_file = [](const FileCall& call) { return io::read_drawing(call.path, {}, call.run); },
      .info = io::describe_vector,
  });
  return kind;
}

void kinds::Drawing::add_formats(Registry& registry) {
  const std::vector<std::string> files = {".geojson", ".gpkg", ".svg"};
  registry.add(make_format<NoParams>(
      {"drawing", "areas and lines: GeoJSON, GeoPackage, SVG", files, files, {&kind()}},
      [](const NoParams&, const OutputCall& call) { io::write_drawing(call.value.get<Drawing>(), call.path); }));
}

}  // namespace seamount::recipe
