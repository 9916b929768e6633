#include "seamount/geom/mesh/tile_texture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace seamount::geom {

Image tile_texture(const Image& whole, MeshPart& tile) {
  const std::array<int, 2> size{whole.width, whole.height};
  std::array<int, 2> first{}, last{};  // pixels, the last one excluded
  for (size_t axis = 0; axis < 2; ++axis) {
    float low = 1.0F, high = 0.0F;
    for (size_t i = axis; i < tile.uvs.size(); i += 2) {
      low = std::min(low, tile.uvs[i]);
      high = std::max(high, tile.uvs[i]);
    }
    first[axis] = std::max(0, static_cast<int>(std::floor(low * static_cast<float>(size[axis]))) - 1);
    last[axis] = std::min(size[axis], static_cast<int>(std::ceil(high * static_cast<float>(size[axis]))) + 1);
  }
  for (size_t i = 0; i < tile.uvs.size(); ++i) {
    const size_t axis = i % 2;
    const double pixel = double{tile.uvs[i]} * size[axis];
    tile.uvs[i] = static_cast<float>((pixel - first[axis]) / (last[axis] - first[axis]));
  }
  Image part(last[0] - first[0], last[1] - first[1]);
  for (int y = 0; y < part.height; ++y)
    std::copy_n(whole.pixel(first[0], first[1] + y), 3 * part.width, part.pixel(0, y));
  return part;
}

}  // namespace seamount::geom
