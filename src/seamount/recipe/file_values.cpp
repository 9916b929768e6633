#include "seamount/recipe/file_values.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "seamount/base/text.h"
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

/// A picture lies over all of the domain, whatever its shape.
void say_stretched(const std::string& path, const io::PlacedImage& picture, const RunContext& run) {
  const GridFrame& frame = picture.frame;
  const double stretch = static_cast<double>(picture.image.width) / std::max(1, picture.image.height) *
                         static_cast<double>(frame.height) / frame.width;
  constexpr double kSameShape = 0.01;
  if (std::abs(stretch - 1.0) <= kSameShape) return;
  run.say(path + ": its " + std::to_string(picture.image.width) + " x " + std::to_string(picture.image.height) +
          " pixels lie over all of the domain, which is of another shape: what is painted is drawn out by " +
          format_number(std::round(100 * (std::max(stretch, 1 / stretch) - 1))) + " % " +
          (stretch < 1 ? "from west to east" : "from south to north"));
}

}  // namespace

bool is_picture(const std::string& path) {
  const std::string extension = io::extension_of(path);
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

PaintedPicture read_painted_picture(const std::string& path, const GridFrame& domain, const RunContext& run) {
  if (std::filesystem::exists(io::sidecar_path(path))) return decode_picture(path, io::read_placed_image(path), run);
  io::PlacedImage picture{io::read_image(path), domain};
  say_stretched(path, picture, run);
  return decode_picture(path, picture, run);
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
