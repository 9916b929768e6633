#include "seamount/geom/mesh/window_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "seamount/base/error.h"
#include "seamount/geom/mesh/terrain_mesh.h"
#include "seamount/geom/mesh/test_surface.h"

namespace seamount::geom {
namespace {

HeightField cut(const HeightField& all, const CellBox& box) {
  const int width = box.last.x - box.first.x + 1, height = box.last.y - box.first.y + 1;
  HeightField part(all.frame().window(box.first.x, box.first.y, width, height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) part(x, y) = all(box.first.x + x, box.first.y + y);
  return part;
}

struct Tile {
  CellBox box;
  std::vector<Mesh> levels;
};

std::vector<Tile> tiles_of(const HeightField& heights, int steps, const WindowMeshOptions& options) {
  std::vector<Tile> tiles;
  const int right = heights.width() - 1, bottom = heights.height() - 1;
  for (int y = 0; y < bottom; y += steps) {
    for (int x = 0; x < right; x += steps) {
      const CellBox box{{x, y}, {std::min(x + steps, right), std::min(y + steps, bottom)}};
      const CellBox around = cells_around(box, heights.frame(), options);
      tiles.push_back({box, window_meshes({cut(heights, around), heights.frame(), around.first}, box, options, {})});
    }
  }
  return tiles;
}

/// A sharp ridge from side to side, over all borders between west and east.
HeightField with_ridge(GridFrame frame, uint64_t seed) {
  HeightField heights = rough_cone(frame, seed);
  for (int x = 0; x < frame.width; ++x) heights(x, frame.height / 3) += 300.0F;
  return heights;
}

using Place = std::array<float, 3>;

/// Normals by place, of vertices on a tile's border.
std::map<Place, Place> border_of(const Mesh& mesh, const CellBox& box, const GridFrame& frame) {
  std::map<Place, Place> border;
  const MeshPart& part = mesh.parts[0];
  for (size_t v = 0; v < part.vertex_count(); ++v) {
    const double column = part.uvs[2 * v] * frame.width - 0.5, row = part.uvs[2 * v + 1] * frame.height - 0.5;
    const auto on = [](double place, int edge) { return std::abs(place - edge) < 0.01; };
    if (!on(column, box.first.x) && !on(column, box.last.x) && !on(row, box.first.y) && !on(row, box.last.y)) continue;
    border[{part.positions[3 * v] + static_cast<float>(mesh.offset.x),
            part.positions[3 * v + 1] + static_cast<float>(mesh.offset.y), part.positions[3 * v + 2]}] = {
        part.normals[3 * v], part.normals[3 * v + 1], part.normals[3 * v + 2]};
  }
  return border;
}

const WindowMeshOptions kFine{.max_error_m = 2.0, .levels = 3};

TEST(WindowMesh, TilesMadeApartCloseWithoutCracksAtAnyLevels) {
  for (const uint64_t seed : {1U, 2U, 3U}) {
    // 60 km from side to side, where floats of the whole have millimetres.
    const GridFrame frame{203, 151, 297.3, 400000.0, 5000000.0, ""};
    const HeightField heights = with_ridge(frame, seed);
    const auto tiles = tiles_of(heights, 64, kFine);
    const double around = 2.0 * 297.3 * (202 + 150);
    for (const int mixed : {0, 1, 2, 3}) {
      std::vector<const Mesh*> meshes;
      for (size_t i = 0; i < tiles.size(); ++i)
        meshes.push_back(&tiles[i].levels[mixed == 3 ? i % 3 : static_cast<size_t>(mixed)]);
      const SurfaceFaults faults = faults_of(meshes);
      EXPECT_EQ(faults.facing_down + faults.without_area + faults.doubled_edges, 0) << seed << " " << mixed;
      EXPECT_NEAR(faults.open_length, around, 1e-3 * around) << "open edges are the terrain's own, " << mixed;
    }
    for (const Tile& tile : tiles)
      for (int level = 0; level < 3; ++level)
        EXPECT_LE(tile.levels[static_cast<size_t>(level)].largest_error_m, level_error_m(kFine, 297.3, level) + 1e-6);
  }
}

TEST(WindowMesh, NeighboursHaveTheSamePlacesAndNormalsAlongTheirBorder) {
  const GridFrame frame{150, 90, 8.0, -300.0, 900.0, ""};
  const auto tiles = tiles_of(with_ridge(frame, 7), 50, kFine);
  std::map<Place, Place> known;
  size_t shared = 0;
  for (const Tile& tile : tiles) {
    for (const Mesh& mesh : tile.levels) {
      for (const auto& [place, normal] : border_of(mesh, tile.box, frame)) {
        const auto [at, is_new] = known.emplace(place, normal);
        EXPECT_EQ(at->second, normal);
        shared += !is_new;
      }
    }
  }
  EXPECT_GT(shared, 300U);
}

TEST(WindowMesh, HasTheSameBytesFromAnyWindowThatIsLargeEnough) {
  const GridFrame frame{120, 110, 5.0, 0.0, 0.0, ""};
  const HeightField heights = with_ridge(frame, 4);
  const CellBox box{{40, 20}, {90, 81}}, around = cells_around(box, frame, kFine), more{{3, 11}, {119, 99}};
  const auto wanted = window_meshes({cut(heights, around), frame, around.first}, box, kFine, {});
  EXPECT_EQ(window_meshes({heights, frame, {0, 0}}, box, kFine, {}), wanted);
  EXPECT_EQ(window_meshes({cut(heights, more), frame, more.first}, box, kFine, {.threads = 1}), wanted);
  EXPECT_NE(window_meshes({cut(heights, box), frame, box.first}, box, kFine, {}), wanted) << "normals look further";
}

TEST(WindowMesh, OfEveryCellIsTheMeshOfTheWhole) {
  const GridFrame frame{41, 30, 3.3, 10.0, 20.0, ""};
  const HeightField heights = rough_cone(frame, 5);
  const Mesh whole = make_mesh(heights, {.water = false}, {});
  const Mesh tile = window_meshes({heights, frame, {0, 0}}, {{0, 0}, {40, 29}}, {}, {})[0];
  EXPECT_EQ(tile.parts[0].indices, whole.parts[0].indices);
  EXPECT_EQ(tile.parts[0].uvs, whole.parts[0].uvs);
  EXPECT_EQ(tile.parts[0].normals, whole.parts[0].normals);
  EXPECT_EQ(tile.offset, Vec2{});
  EXPECT_EQ(tile.parts[0].positions, whole.parts[0].positions);
}

TEST(WindowMesh, RefusesNonsense) {
  const GridFrame frame{9, 9, 1.0, 0.0, 0.0, ""};
  HeightField heights(frame, 1.0F);
  const auto make = [&](const WindowMeshOptions& options) {
    window_meshes({heights, frame, {0, 0}}, {{0, 0}, {8, 8}}, options, {});
  };
  EXPECT_THROW(make({.max_error_m = -1.0}), InvalidArgument);
  EXPECT_THROW(make({.levels = 0}), InvalidArgument);
  EXPECT_THROW(make({.vertical_scale = 0.0}), InvalidArgument);
  heights(4, 4) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(make({}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::geom
