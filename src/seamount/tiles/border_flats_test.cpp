// Flats over the borders of tiles against the whole: geom::flow_directions() is the judge.
#include "seamount/tiles/border_flats.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "seamount/base/rng.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/water/inland.h"

namespace seamount::tiles {
namespace {

HeightField level(int width, int height, float z) { return HeightField(GridFrame::centred(width, height, 10), z); }

std::vector<int32_t> first_nodes(const Layout& layout) {
  std::vector<int32_t> first(1, 1);
  for (int tile = 0; tile < layout.count(); ++tile) first.push_back(first.back() + rim_size(layout, tile));
  return first;
}

struct Drained {
  geom::FlowDirections directions;
  int most_walks = 0;  ///< of a tile
};

Drained drain_in_tiles(const HeightField& filled, int tile_size, float sea) {
  const Layout layout(filled.frame(), tile_size);
  const std::vector<int32_t> first = first_nodes(layout);
  const Rect all{0, 0, filled.width(), filled.height()};
  BorderFlats flats(layout, first);
  std::vector<geom::FlowDirections> marked;
  for (int tile = 0; tile < layout.count(); ++tile) {
    const Rect rect = layout.tile(tile), window = with_reach(rect, Reach::neighbourhood(2), filled.frame());
    const geom::PieceIn piece{rect.column - window.column, rect.row - window.row, rect.width, rect.height};
    marked.push_back(geom::piece_directions(inner(filled, all, window), piece, sea, {}));
    flats.add(tile, look_at_flats(marked.back(), {}));
  }
  flats.settle();
  std::map<int, int> walks;
  for (std::vector<int> tiles = flats.next_tiles(); !tiles.empty(); tiles = flats.next_tiles()) {
    std::vector<Reached> reached;
    for (const int tile : tiles) {
      ++walks[tile];
      const auto more = flats.walk(tile, marked[static_cast<size_t>(tile)], {});
      reached.insert(reached.end(), more.begin(), more.end());
    }
    flats.lower(reached);
  }
  EXPECT_EQ(flats.waiting(), 0);
  Drained drained{geom::FlowDirections(filled.frame()), 0};
  for (const auto& [tile, times] : walks) drained.most_walks = std::max(drained.most_walks, times);
  for (int tile = 0; tile < layout.count(); ++tile) {
    geom::FlowDirections& codes = marked[static_cast<size_t>(tile)];
    flats.aim(tile, codes, {});
    const Rect rect = layout.tile(tile);
    for (int y = 0; y < rect.height; ++y)
      for (int x = 0; x < rect.width; ++x) drained.directions(rect.column + x, rect.row + y) = codes(x, y);
  }
  return drained;
}

/// Fills the ground and drains it both ways. How often the tile was walked that was walked most.
int compare(const HeightField& ground, int tile_size, float sea = geom::kNoSea) {
  const HeightField filled = geom::fill_depressions(ground, sea, {});
  const geom::FlowDirections whole = geom::flow_directions(filled, sea, {});
  const Drained drained = drain_in_tiles(filled, tile_size, sea);
  int64_t differ = 0, first = -1;
  for (size_t i = 0; i < whole.size(); ++i) {
    if (whole.data()[i] == drained.directions.data()[i]) continue;
    ++differ;
    if (first < 0) first = static_cast<int64_t>(i);
  }
  EXPECT_EQ(differ, 0) << "in tiles of " << tile_size << ", first at column " << first % whole.width() << ", row "
                       << first / whole.width();
  return drained.most_walks;
}

TEST(BorderFlats, OfAnyGroundAreThoseOfTheWhole) {
  for (const uint64_t seed : {1, 2, 3}) {
    HeightField ground =
        geom::fbm_grid(GridFrame::centred(97, 71, 10), Seed{seed}, {.wavelength_m = 300, .octaves = 5}, {});
    for (const float steps : {2.0F, 6.0F, 30.0F}) {
      HeightField stepped = ground;
      for (float& z : stepped.cells()) z = std::round(steps * z + 0.4F);
      for (const int tile : {1, 2, 3, 16, 23, 70, 200}) {
        compare(stepped, tile);
        compare(stepped, tile, 0.0F);
      }
    }
  }
}

TEST(BorderFlats, MayTouchTheUnknownAndTheSea) {
  for (const uint64_t seed : {1, 2, 3}) {
    HeightField ground = level(83, 64, 40.0F);
    Rng rng(Seed{seed});
    for (float& z : ground.cells()) {
      const int64_t kind = rng.integer(0, 199);
      z = kind == 0 ? geom::kUnknownGround : kind == 1 ? -3.0F : kind < 20 ? 50.0F : z;
    }
    for (const int tile : {5, 16, 31}) compare(ground, tile, 0.0F);
  }
}

/// Nothing but one lake, whose only way out is a cell of the edge, or some.
TEST(BorderFlats, OfTheWholeWorldAreWalkedAFewTimes) {
  for (const std::vector<int>& outlets : {std::vector{0}, {130}, {7, 40, 129}}) {
    HeightField ground = level(131, 131, 10.0F);
    for (int i = 0; i < 131; ++i) ground(i, 0) = ground(0, i) = ground(i, 130) = ground(130, i) = 20.0F;
    for (const int x : outlets) ground(x, 0) = ground(x, 1) = 10.0F;
    for (const int tile : {16, 33, 64}) EXPECT_LE(compare(ground, tile), 4) << "in tiles of " << tile;
  }
}

/// A way in a spiral from the edge to the middle, between walls.
HeightField spiral(int size, int width) {
  HeightField ground = level(size, size, 30.0F);
  int x = 0, y = 0, k = 0;
  const int step = width + 1;
  const auto free = [&](int cx, int cy) { return ground.contains(cx, cy) && ground(cx, cy) == 30.0F; };
  const auto dig = [&](int cx, int cy) {
    for (int dy = 0; dy < width; ++dy)
      for (int dx = 0; dx < width; ++dx)
        if (ground.contains(cx + dx, cy + dy)) ground(cx + dx, cy + dy) = 10.0F;
  };
  constexpr std::array<int, 4> kDx = {1, 0, -1, 0}, kDy = {0, 1, 0, -1};
  x = y = 1;
  dig(x, y);
  for (int turns = 0; turns < 2;) {
    const int nx = x + kDx[static_cast<size_t>(k)] * step, ny = y + kDy[static_cast<size_t>(k)] * step;
    if (nx < 1 || ny < 1 || nx + width >= size || ny + width >= size || !free(nx, ny)) {
      k = (k + 1) % 4;
      ++turns;
      continue;
    }
    for (int i = 1; i <= step; ++i) dig(x + kDx[static_cast<size_t>(k)] * i, y + kDy[static_cast<size_t>(k)] * i);
    x = nx;
    y = ny;
    turns = 0;
  }
  return ground;
}

TEST(BorderFlats, WindThroughAllTiles) {
  for (const int width : {1, 2, 3, 7}) {
    HeightField ground = spiral(151, width);
    ground(0, 1) = 10.0F;  // out at its outer end
    for (const int tile : {19, 40, 64}) {
      const int walks = compare(ground, tile);
      if (width == 1) {
        EXPECT_LE(walks, 2) << "narrow ways are links";
      }
      EXPECT_LE(walks, tile / (width + 1) + 3) << "in tiles of " << tile << ", " << width << " wide";
    }
    ground(0, 1) = 30.0F;
    ground(75, 75) = -1.0F;  // into the sea about its inner end
    for (const int tile : {19, 40}) compare(ground, tile, 0.0F);
  }
}

TEST(BorderFlats, OfOneRowOrColumn) {
  for (const auto& [width, height] : {std::pair{1, 40}, {40, 1}, {3, 40}, {40, 3}, {2, 2}, {1, 1}}) {
    HeightField ground = level(width, height, 5.0F);
    if (width > 2 && height > 2) ground(0, 1) = 4.0F;
    for (const int tile : {1, 7}) compare(ground, tile);
  }
}

}  // namespace
}  // namespace seamount::tiles
