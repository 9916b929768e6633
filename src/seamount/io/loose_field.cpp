#include "seamount/io/loose_field.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "seamount/io/atomic_file.h"
#include "seamount/io/image_file.h"
#include "seamount/io/png_codec.h"
#include "seamount/io/raster.h"
#include "seamount/io/raster_files.h"

namespace seamount::io {
namespace {

constexpr int kTint = 24;  // between channels: what is more is a colour, no noise of a JPEG

bool is_jpeg_name(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".jpg" || extension == ".jpeg";
}

/// Whether a PNG has colours, which only its brightness can mean here.
bool is_colour_png(const std::string& path) {
  if (extension_of(path) != ".png" || std::filesystem::exists(sidecar_path(path))) return false;
  const Image image = read_image(path);
  for (size_t i = 0; i < image.rgb.size(); i += 3)
    if (image.rgb[i] != image.rgb[i + 1] || image.rgb[i] != image.rgb[i + 2]) return true;
  return false;
}

/// Luma after ITU-R BT.601, in [0, 1].
ScalarField brightness(const std::string& path, const RunContext& run) {
  const Image image = read_image(path);
  ScalarField values(GridFrame::centred(image.width, image.height, 1.0));
  bool coloured = false;
  for (size_t i = 0; i < values.size(); ++i) {
    const int r = image.rgb[3 * i], g = image.rgb[3 * i + 1], b = image.rgb[3 * i + 2];
    coloured = coloured || std::max({r, g, b}) - std::min({r, g, b}) > kTint;
    values.data()[i] = static_cast<float>(299 * r + 587 * g + 114 * b) / 255000.0F;
  }
  if (coloured) run.say(path + ": is a picture in colours; their brightness counts");
  return values;
}

}  // namespace

LooseField read_loose_field(const std::string& path, const ReadOptions& options) {
  if (is_jpeg_name(path) || is_colour_png(path)) return {brightness(path, options.run), false};
  Loaded loaded = load_raster(path, options, Meaning::field);
  if (loaded.sidecar || loaded.stored.placement)
    return {finish_raster(std::move(loaded), path, options, Meaning::field), true};
  if (loaded.stored.code_max > 0) {
    int64_t clear = 0;
    for (float& value : loaded.stored.values.cells()) {
      if (!std::isnan(value)) continue;
      value = 0.0F;
      ++clear;
    }
    if (clear > 0) options.run.say(path + ": " + std::to_string(clear) + " transparent pixels count as black");
  }
  ReadOptions own = options;
  own.cell_m = 1.0;
  return {finish_raster(std::move(loaded), path, own, Meaning::mask), false};
}

}  // namespace seamount::io
