// terrain: heights in metres.
#include "seamount/io/raster.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/frame_bytes.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/kinds/rasters.h"

namespace seamount::recipe {

const Kind& kinds::Terrain::kind() {
  static const Kind kind = make_kind<HeightField>({
      .name = "terrain",
      .about = "heights in metres",
      .files = {".tif"},
      .reads = io::readable_raster_extensions(),
      .frame = [](const HeightField& terrain) { return &terrain.frame(); },
      .bring = bring_raster<float>,
      .without_voids = fill_raster,
      .bytes = [](const HeightField& terrain) { return terrain.size() * sizeof(float); },
      .write = write_grid<float>,
      .read = read_grid<float>,
      .read_file = [](const FileCall& call) { return io::read_heights(call.path, read_options(call)); },
      .info = io::describe_raster,
  });
  return kind;
}

void kinds::Terrain::add_formats(Registry& registry) {
  add_raster_format(registry);
  add_engine_formats(registry);
  add_gazebo_format(registry);
  add_mesh_format(registry);
  add_splat_format(registry);
  add_picture_formats(registry);
}

}  // namespace seamount::recipe
