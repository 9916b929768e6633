// Painting; reading is painted_labels_decode.cpp.
#include "seamount/geom/grid/painted_labels.h"

#include "seamount/base/error.h"

namespace seamount::geom {

Image encode_labels(const LabelMap& labels, double subsidence) {
  if (labels.empty()) throw InvalidArgument("labels", "there are no cells");
  std::array<Colour, kRegionCount> colours;
  for (const Region region : kRegions) colours[static_cast<size_t>(region)] = painted_colour(region, subsidence);
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

}  // namespace seamount::geom
