#include "seamount/recipe/file_values.h"

#include <algorithm>
#include <filesystem>

#include "seamount/geom/grid/painted_labels.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/image_file.h"
#include "seamount/io/raster.h"

namespace seamount::recipe {
namespace {

constexpr float kSunk = 0.02F;  // less is noise of the picture

PaintedPicture decode_picture(const std::string& path, const io::PlacedImage& picture, const RunContext& run) {
  try {
    geom::PaintedLabels painted = geom::decode_labels(picture.image, picture.frame, run);
    const auto& sunk = painted.subsidence_per_cell.cells();
    const bool any = std::any_of(sunk.begin(), sunk.end(), [](float lambda) { return lambda > kSunk; });
    return {std::move(painted.labels), any ? std::move(painted.subsidence_per_cell) : ScalarField()};
  } catch (const InvalidArgument& error) {
    throw IoError(path, error.what());
  }
}

}  // namespace

bool is_picture(const std::string& path) {
  const std::string extension = io::extension_of(path);
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

PaintedPicture read_painted_picture(const std::string& path, const GridFrame& domain, const RunContext& run) {
  if (std::filesystem::exists(io::sidecar_path(path))) return decode_picture(path, io::read_placed_image(path), run);
  return decode_picture(path, {io::read_image(path), domain}, run);
}

LabelMap read_label_picture(const std::string& path, const GridFrame& domain, const RunContext& run) {
  PaintedPicture picture = read_painted_picture(path, domain, run);
  if (!picture.subsidence.empty())
    run.say("the brightness of " + path +
            " says that the island has sunk; labels hold only its regions: give the picture as the coast of "
            "island.build and heights sink with it");
  return std::move(picture.labels);
}

}  // namespace seamount::recipe
