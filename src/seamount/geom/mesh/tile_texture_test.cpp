#include "seamount/geom/mesh/tile_texture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/geom/mesh/terrain_mesh.h"

namespace seamount::geom {
namespace {

TEST(TileTexture, ShowsEachVertexThePixelThatTheWholeDoes) {
  Image whole(97, 61);
  for (int y = 0; y < whole.height; ++y)
    for (int x = 0; x < whole.width; ++x)
      whole.pixel(x, y)[0] = static_cast<uint8_t>(2 * x), whole.pixel(x, y)[1] = static_cast<uint8_t>(3 * y);
  const HeightField heights(GridFrame::centred(120, 75, 10), 5.0F);
  int tiles = 0;
  const auto look_at = [](const Image& image, const MeshPart& part, size_t v) {
    return image.colour(
        std::min(image.width - 1, static_cast<int>(part.uvs[2 * v] * static_cast<float>(image.width))),
        std::min(image.height - 1, static_cast<int>(part.uvs[2 * v + 1] * static_cast<float>(image.height))));
  };
  make_mesh_tiles(heights, {}, {.across = 3},
                  [&](const MeshTile& tile) {
                    const MeshPart& before = tile.mesh.parts[0];
                    MeshPart after = before;
                    const Image part = tile_texture(whole, after);
                    EXPECT_LT(part.width, 97 / 3 + 5);
                    for (size_t v = 0; v < before.vertex_count(); ++v) {
                      const Colour old_one = look_at(whole, before, v), new_one = look_at(part, after, v);
                      EXPECT_LE(std::abs(old_one.r - new_one.r), 2) << "a pixel's width, where rounding decides";
                      EXPECT_LE(std::abs(old_one.g - new_one.g), 3);
                    }
                    ++tiles;
                  },
                  {});
  EXPECT_EQ(tiles, 6);
}

}  // namespace
}  // namespace seamount::geom
