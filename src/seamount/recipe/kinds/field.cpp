// field: any scalar of each cell but height.
#include <cmath>

#include "seamount/io/loose_field.h"
#include "seamount/io/raster.h"
#include "seamount/recipe/frame_bytes.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/kinds/rasters.h"
#include "seamount/recipe/laid_over.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {
namespace {

std::vector<std::string> field_files() {
  std::vector<std::string> all = io::readable_raster_extensions();
  all.insert(all.end(), {".jpg", ".jpeg"});
  return all;
}

std::string sides(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

/// A raster, or a picture laid over the frame if nothing says where it lies.
ScalarField read_field_file(const FileCall& call) {
  const io::LooseField read = io::read_loose_field(call.path, read_options(call));
  if (read.placed) return read.values;
  const GridFrame& own = read.values.frame();
  const double stretch = static_cast<double>(own.width) / own.height * call.frame.height / call.frame.width;
  constexpr double kSameShape = 0.01;
  call.run.say(call.path +
               ": says nothing of its place and lies over all of the terrain or domain, black 0 and white 1" +
               (std::abs(stretch - 1.0) <= kSameShape
                    ? std::string()
                    : "; its " + sides(own.width, own.height) + " pixels are of another shape than the " +
                          sides(call.frame.width, call.frame.height) + " cells there and are stretched"));
  return laid_over(read.values, call.frame, call.run);
}

}  // namespace

const Kind& kinds::Field::kind() {
  static const Kind kind = make_kind<ScalarField>({
      .name = "field",
      .about = "any other number of each cell",
      .files = {".tif"},
      .reads = field_files(),
      .frame = [](const ScalarField& field) { return &field.frame(); },
      .bring = bring_raster<float>,
      .without_voids = fill_raster,
      .bytes = [](const ScalarField& field) { return field.size() * sizeof(float); },
      .write = write_grid<float>,
      .read = read_grid<float>,
      .read_file = read_field_file,
      .info = {},  // their files are rasters
  });
  return kind;
}

void kinds::Field::add_formats(Registry&) {}  // the format of terrains takes them too

}  // namespace seamount::recipe
