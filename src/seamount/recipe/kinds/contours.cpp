// contours: nested closed contours.
#include "seamount/base/fields.h"
#include "seamount/geom/contour/lines.h"
#include "seamount/io/reproject.h"
#include "seamount/io/vector.h"
#include "seamount/recipe/contour_file.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/frame_bytes.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

struct ContourFileParams {
  bool cut_at_frame = true;

  static constexpr auto fields() {
    return std::tuple(field(&ContourFileParams::cut_at_frame, "cut_at_frame",
                            "lines end where they leave the frame, as on a map sheet (reading closes them again); off: "
                            "all are closed and run along its border"));
  }
};

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

ContourSet read_contour_file(const FileCall& call) { return contours_of_file(call.path, {}, call.frame, call.run); }

}  // namespace

ContourSet contours_of_file(const std::string& path, const io::VectorOptions& options, const GridFrame& frame,
                            const RunContext& run) {
  io::SheetLines read = io::read_contour_lines(path, options, run);
  RunContext named = run;
  if (run.note) named.note = [&](const std::string& line) { run.say(path + ": " + line); };
  try {
    return geom::contours_from_lines(read.drawing, frame, "contours", read.sheet, named);
  } catch (const InvalidArgument& error) {
    throw IoError(path, error.what());
  }
}

const Kind& kinds::Contours::kind() {
  static const Kind kind = make_kind<ContourSet>({
      .name = "contours",
      .about = "nested contours with their heights; open lines are closed at the sheet's border",
      .files = {".gpkg"},
      .reads = {".geojson", ".json", ".gpkg", ".shp", ".svg"},
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
  registry.add(make_format<ContourFileParams>(
      {"contours",
       "contours with their heights, as attribute and as z: GeoPackage, GeoJSON, SVG",
       files,
       files,
       {&kind()}},
      [](const ContourFileParams& params, const OutputCall& call) {
        const auto& set = call.value.get<Contours>();
        io::write_drawing(params.cut_at_frame ? geom::to_cut_lines(set) : geom::to_lines(set), call.path);
      }));
}

}  // namespace seamount::recipe
