// terrain: heights in metres.
#include "seamount/io/mesh_info.h"
#include "seamount/io/raster.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/frame_bytes.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/kinds/rasters.h"

namespace seamount::recipe {

namespace {

/// A raster, or a mesh that a terrain was written to.
std::optional<io::FileInfo> describe(const std::string& path) {
  std::optional<io::FileInfo> info = io::describe_raster(path);
  return info ? info : io::describe_mesh(path);
}

}  // namespace

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
      .info = describe,
  });
  return kind;
}

void kinds::Terrain::add_formats(Registry& registry) {
  add_raster_format(registry);
  add_engine_formats(registry);
  add_tiles_format(registry);
  add_gazebo_format(registry);
  add_mesh_format(registry);
  add_mesh_tiles_format(registry);
  add_splat_format(registry);
  add_bundle_format(registry);
  add_picture_formats(registry);
}

}  // namespace seamount::recipe
