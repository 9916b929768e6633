#include "seamount/io/label_image.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/text.h"

namespace seamount::io {

Colour region_colour(Region region, double subsidence) {
  if (!(subsidence >= 0 && subsidence <= 1))
    throw InvalidArgument("subsidence", format_number(subsidence) + " is outside [0, 1]");
  constexpr std::array<std::array<int, 3>, kRegionCount> kPure = {
      {{1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 0}}};
  const auto value = static_cast<uint8_t>(std::lround(255.0 * (1.0 - 0.8 * subsidence)));
  const auto& pure = kPure[static_cast<size_t>(region)];
  const auto channel = [&](size_t c) { return static_cast<uint8_t>(pure[c] * value); };
  return {channel(0), channel(1), channel(2)};
}

Image encode_labels(const LabelMap& labels, double subsidence) {
  if (labels.empty()) throw InvalidArgument("labels", "there are no cells");
  std::array<Colour, kRegionCount> colours;
  for (const Region region : kRegions) colours[static_cast<size_t>(region)] = region_colour(region, subsidence);
  Image image(labels.width(), labels.height());
  for (int y = 0; y < labels.height(); ++y) {
    for (int x = 0; x < labels.width(); ++x) {
      const Colour colour = colours[static_cast<size_t>(labels(x, y))];
      uint8_t* pixel = image.pixel(x, y);
      pixel[0] = colour.r, pixel[1] = colour.g, pixel[2] = colour.b;
    }
  }
  return image;
}

}  // namespace seamount::io
