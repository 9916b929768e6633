// current: a flow at each cell, m/s.
#include <cmath>

#include "seamount/io/current_file.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/frame_bytes.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/kinds/rasters.h"

namespace seamount::recipe {
namespace {

VectorField bring(const VectorField& current, const Destination& to) {
  return to.cells ? io::on_cells(current, to.frame, to.run) : io::in_system(current, to.frame.crs, to.run);
}

/// Models of the sea know no currents on land: where there is no value nothing flows.
std::optional<VectorField> without_voids(const VectorField& current, const std::string& name, const RunContext& run) {
  int64_t voids = 0;
  for (size_t i = 0; i < current.x.size(); ++i)
    voids += std::isnan(current.x.cells()[i]) || std::isnan(current.y.cells()[i]) ? 1 : 0;
  if (voids == 0) return std::nullopt;
  VectorField filled = current;
  for (size_t i = 0; i < filled.x.size(); ++i) {
    float &u = filled.x.cells()[i], &v = filled.y.cells()[i];
    if (std::isnan(u) || std::isnan(v)) u = v = 0.0F;
  }
  run.say(name + ": " + std::to_string(voids) + " of " + std::to_string(filled.x.size()) +
          " cells have no value and are taken to be still");
  return filled;
}

void write(Writer& writer, const VectorField& current) {
  write_grid(writer, current.x);
  write_grid(writer, current.y);
}

VectorField read(Reader& reader) {
  VectorField current;
  current.x = read_grid<float>(reader);
  current.y = read_grid<float>(reader);
  if (current.x.frame() != current.y.frame()) throw Damaged();
  return current;
}

}  // namespace

const Kind& kinds::Current::kind() {
  static const Kind kind = make_kind<VectorField>({
      .name = "current",
      .about = "the flow at each cell, m/s",
      .files = {".tif"},
      .reads = {".tif", ".tiff"},
      .frame = [](const VectorField& current) { return &current.frame(); },
      .bring = bring,
      .without_voids = without_voids,
      .bytes = [](const VectorField& current) { return 2 * current.x.size() * sizeof(float); },
      .write = write,
      .read = read,
      .read_file = [](const FileCall& call) { return io::read_current(call.path, read_options(call)); },
      .info = {},  // their files are rasters
  });
  return kind;
}

void kinds::Current::add_formats(Registry& registry) {
  const std::vector<std::string> files = {".tif"};
  registry.add(make_format<NoParams>(
      {"current", "a current: GeoTIFF of its east and north components, m/s", files, files, {&kind()}},
      [](const NoParams&, const OutputCall& call) {
        io::write_current(call.value.get<Current>(), call.path, {.provenance = call.provenance});
      }));
}

}  // namespace seamount::recipe
