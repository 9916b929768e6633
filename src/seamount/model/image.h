// A picture: 8 bits a channel, sRGB, row 0 on top.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "seamount/model/drawn.h"

namespace seamount {

struct Image {
  int width = 0;
  int height = 0;
  std::vector<uint8_t> rgb;  ///< 3 * width * height values

  Image() = default;
  Image(int w, int h, Colour fill = {})
      : width(w), height(h), rgb(size_t{3} * static_cast<size_t>(w) * static_cast<size_t>(h)) {
    for (size_t i = 0; i < rgb.size(); i += 3) {
      rgb[i] = fill.r;
      rgb[i + 1] = fill.g;
      rgb[i + 2] = fill.b;
    }
  }

  uint8_t* pixel(int x, int y) {
    return rgb.data() + 3 * (static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x));
  }
  const uint8_t* pixel(int x, int y) const {
    return rgb.data() + 3 * (static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x));
  }
  Colour colour(int x, int y) const {
    const uint8_t* p = pixel(x, y);
    return {p[0], p[1], p[2]};
  }

  bool operator==(const Image&) const = default;
};

}  // namespace seamount
