#include "seamount/recipe/file_values.h"

#include <filesystem>

#include "seamount/geom/grid/painted_labels.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/image_file.h"
#include "seamount/io/raster.h"

namespace seamount::recipe {
namespace {

LabelMap decode_picture(const std::string& path, const io::PlacedImage& picture, const RunContext& run) {
  try {
    return geom::decode_labels(picture.image, picture.frame, run).labels;
  } catch (const InvalidArgument& error) {
    throw IoError(path, error.what());
  }
}

}  // namespace

bool is_picture(const std::string& path) {
  const std::string extension = io::extension_of(path);
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

LabelMap read_label_picture(const std::string& path, const GridFrame& domain, const RunContext& run) {
  if (std::filesystem::exists(io::sidecar_path(path))) return decode_picture(path, io::read_placed_image(path), run);
  return decode_picture(path, {io::read_image(path), domain}, run);
}

}  // namespace seamount::recipe
