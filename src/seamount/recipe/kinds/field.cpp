// field: any scalar of each cell but height.
#include "seamount/io/raster.h"
#include "seamount/recipe/frame_bytes.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/kinds/rasters.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

const Kind& kinds::Field::kind() {
  static const Kind kind = make_kind<ScalarField>({
      .name = "field",
      .about = "any other number of each cell",
      .files = {".tif"},
      .reads = io::readable_raster_extensions(),
      .frame = [](const ScalarField& field) { return &field.frame(); },
      .bring = bring_raster<float>,
      .without_voids = fill_raster,
      .bytes = [](const ScalarField& field) { return field.size() * sizeof(float); },
      .write = write_grid<float>,
      .read = read_grid<float>,
      .read_file = [](const FileCall& call) { return io::read_field(call.path, read_options(call)); },
      .info = {},  // their files are rasters
  });
  return kind;
}

void kinds::Field::add_formats(Registry&) {}  // the format of terrains takes them too

}  // namespace seamount::recipe
