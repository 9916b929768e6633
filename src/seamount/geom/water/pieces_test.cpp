#include "seamount/geom/water/pieces.h"

#include <gtest/gtest.h>

#include <set>

#include "seamount/geom/scalar/noise.h"

namespace seamount::geom {
namespace {

HeightField hills(int width, int height) {
  HeightField made =
      fbm_grid(GridFrame::centred(width, height, 10.0), Seed{4}, {.wavelength_m = 160, .octaves = 5}, {});
  for (float& z : made.cells()) z = std::round(40.0F * z + 6.0F);  // whole metres: flats and ties
  return made;
}

TEST(Rim, NumbersEachCellOnceAndBack) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 2}, {1, 9}, {7, 1}, {2, 2}, {2, 5}, {6, 2}, {5, 4}}) {
    std::set<int32_t> numbers;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const int32_t number = rim_number(x, y, width, height);
        const bool on_rim = x == 0 || y == 0 || x == width - 1 || y == height - 1;
        ASSERT_EQ(number >= 0, on_rim);
        if (!on_rim) continue;
        EXPECT_TRUE(numbers.insert(number).second);
        EXPECT_EQ(rim_cell(number, width, height), y * width + x);
      }
    }
    EXPECT_EQ(static_cast<int32_t>(numbers.size()), rim_size(width, height));
    EXPECT_EQ(*numbers.rbegin(), rim_size(width, height) - 1);
  }
}

TEST(FloodPiece, OfTheWholeIsFilling) {
  for (const auto& [width, height] : {std::pair{60, 45}, {1, 20}, {20, 1}, {3, 3}}) {
    const HeightField terrain = hills(width, height);
    for (const float sea : {0.0F, kNoSea}) {
      const Flooded flooded = flood_piece(terrain, sea, {true, true, true, true}, {});
      EXPECT_EQ(flooded.filled, fill_depressions(terrain, sea, {}));
      EXPECT_TRUE(flooded.spills.empty()) << "all reach the outside";
    }
  }
}

/// Without an open side all goes over the rim; the graph leads from there to one open cell beside it.
TEST(FloodPiece, ItsGraphGivesTheLevels) {
  const HeightField terrain = hills(40, 30);
  const Flooded flooded = flood_piece(terrain, kNoSea, {}, {});
  std::vector<Spill> spills = flooded.spills;
  for (const int y : {10, 11, 12}) spills.push_back({0, rim_number(39, y, 40, 30) + 1, terrain(39, y)});
  const std::vector<float> levels = overflow_levels(rim_size(40, 30) + 1, spills);
  HeightField walled(GridFrame::centred(42, 32, 10.0), 1000.0F);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) walled(x + 1, y + 1) = terrain(x, y);
  walled(41, 12) = -100.0F;
  const HeightField filled = fill_depressions(walled, kNoSea, {});
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      const float level = levels[static_cast<size_t>(flooded.basins(x, y))];
      EXPECT_EQ(std::max(flooded.filled(x, y), level), filled(x + 1, y + 1)) << x << ", " << y;
    }
  }
}

TEST(GatherPiece, OfTheWholeIsAccumulation) {
  const HeightField filled = fill_depressions(hills(60, 45), 0.0F, {});
  const FlowDirections codes = flow_directions(filled, 0.0F, {});
  const Grid<uint32_t> cells = flow_accumulation(codes, {});
  const Grid<uint64_t> gathered =
      gather_piece(codes, std::vector<uint64_t>(static_cast<size_t>(rim_size(60, 45)), 0), {});
  for (size_t i = 0; i < cells.size(); ++i) ASSERT_EQ(gathered.data()[i], cells.data()[i]);
  for (const int32_t exit : rim_exits(codes)) EXPECT_EQ(exit, -1) << "nothing leaves the whole";
}

TEST(RimExits, FollowTheWayThroughAPiece) {
  FlowDirections codes(GridFrame::centred(4, 3, 1.0), uint8_t{0});  // all to the east, out of the piece
  codes(2, 1) = kPit;
  const std::vector<int32_t> exits = rim_exits(codes);
  EXPECT_EQ(exits[static_cast<size_t>(rim_number(0, 0, 4, 3))], rim_number(3, 0, 4, 3));
  EXPECT_EQ(exits[static_cast<size_t>(rim_number(0, 1, 4, 3))], -1);
  EXPECT_EQ(exits[static_cast<size_t>(rim_number(3, 1, 4, 3))], rim_number(3, 1, 4, 3));
  std::vector<uint64_t> entering(exits.size(), 0);
  entering[static_cast<size_t>(rim_number(0, 0, 4, 3))] = 100;
  EXPECT_EQ(gather_piece(codes, entering, {})(3, 0), 104U);
}

TEST(FindWaters, HangTogetherByCornersAndKnowTheEdge) {
  HeightField terrain(GridFrame::centred(7, 5, 10.0), 5.0F);
  terrain(1, 1) = -3;
  terrain(2, 2) = -8;
  terrain(5, 2) = -1;
  terrain(6, 2) = -1;
  const PieceWaters inside = find_waters(terrain, 0.0F, {}, {});
  ASSERT_EQ(inside.all.size(), 2U);
  EXPECT_EQ(inside.all[0].cells, 2);
  EXPECT_EQ(inside.all[0].lowest, -8);
  EXPECT_FALSE(inside.all[1].open);
  EXPECT_EQ(inside.of(2, 2), 0);
  EXPECT_TRUE(find_waters(terrain, 0.0F, {.east = true}, {}).all[1].open);
}

}  // namespace
}  // namespace seamount::geom
