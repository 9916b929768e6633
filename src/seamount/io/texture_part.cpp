#include "seamount/io/texture_part.h"

#include <algorithm>
#include <cmath>

namespace seamount::io {
namespace {

/// Pixels of a part along one axis, and where each lies in the picture, in its pixels.
struct Axis {
  double begin_m, span_m, pixel_m;  ///< the part, from the picture's edge; of the picture
  int picture, count;

  double place(int i) const {
    return std::clamp((begin_m + (i + 0.5) * span_m / count) / pixel_m - 0.5, 0.0, picture - 1.0);
  }
};

Image part_of(const Image& picture, const Axis& across, const Axis& down) {
  Image part(across.count, down.count);
  for (int y = 0; y < part.height; ++y) {
    const double row = down.place(y);
    const int top = std::min(static_cast<int>(row), picture.height - 1), below = std::min(top + 1, picture.height - 1);
    for (int x = 0; x < part.width; ++x) {
      const double column = across.place(x);
      const int left = std::min(static_cast<int>(column), picture.width - 1),
                right = std::min(left + 1, picture.width - 1);
      const double fx = column - left, fy = row - top;
      for (int c = 0; c < 3; ++c) {
        const double upper = picture.pixel(left, top)[c] * (1 - fx) + picture.pixel(right, top)[c] * fx;
        const double lower = picture.pixel(left, below)[c] * (1 - fx) + picture.pixel(right, below)[c] * fx;
        part.pixel(x, y)[c] = static_cast<uint8_t>(std::lround(upper * (1 - fy) + lower * fy));
      }
    }
  }
  return part;
}

/// `margin` cells beyond the outer samples.
Image part_with(const Image& picture, const GridFrame& of, const GridFrame& samples, double margin) {
  const double cell = samples.cell_m;
  const double pixel_m = of.width_m() / picture.width;
  const double width_m = cell * (samples.width - 1 + 2 * margin), height_m = cell * (samples.height - 1 + 2 * margin);
  const auto pixels = [&](double span_m) {
    return std::clamp(static_cast<int>(std::lround(span_m / pixel_m)), 2, 16384);
  };
  return part_of(
      picture, {samples.x(-margin) - of.west_m, width_m, pixel_m, picture.width, pixels(width_m)},
      {of.north_m - samples.y(-margin), height_m, of.height_m() / picture.height, picture.height, pixels(height_m)});
}

}  // namespace

Image texture_between(const Image& picture, const GridFrame& of, const GridFrame& samples) {
  return part_with(picture, of, samples, 0.0);
}

Image texture_over(const Image& picture, const GridFrame& of, const GridFrame& samples) {
  return part_with(picture, of, samples, 0.5);
}

}  // namespace seamount::io
