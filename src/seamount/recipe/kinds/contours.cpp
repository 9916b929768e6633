// contours: nested closed contours.
#include "seamount/geom/contour/lines.h"
#include "seamount/io/reproject.h"
#include "seamount/io/vector.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/frame_bytes.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

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

size_t size_of(const ContourSet& set) {
  size_t points = 0;
  for (const Contour& contour : set.contours) points += contour.ring.size();
  return points * sizeof(Vec2);
}

ContourSet read_contour_file(const FileCall& call) {
  try {
    return geom::contours_from_lines(io::read_drawing(call.path, {}, call.run), call.frame, "contours");
  } catch (const InvalidArgument& error) {
    throw IoError(call.path, error.what());
  }
}

}  // namespace

const Kind& kinds::Contours::kind() {
  static const Kind kind = make_kind<ContourSet>({
      .name = "contours",
      .about = "nested closed contours with their heights",
      .files = {".gpkg"},
      .reads = {".geojson", ".json", ".gpkg", ".shp"},
      .frame = [](const ContourSet& set) { return &set.frame; },
      .bring = [](const ContourSet& set, const Destination& to) { return io::in_system(set, to.frame.crs); },
      .bytes = size_of,
      .write = write_contours,
      .read = read_contours,
      .read_file = read_contour_file,
      .info = {},  // their files are drawings
  });
  return kind;
}

void kinds::Contours::add_formats(Registry& registry) {
  const std::vector<std::string> files = {".geojson", ".gpkg", ".svg"};
  registry.add(make_format<NoParams>({"contours",
                                      "contours with their heights, as attribute and as z: GeoPackage, GeoJSON, SVG",
                                      files,
                                      files,
                                      {&kind()}},
                                     [](const NoParams&, const OutputCall& call) {
                                       io::write_drawing(geom::to_lines(call.value.get<Contours>()), call.path);
                                     }));
}

}  // namespace seamount::recipe
