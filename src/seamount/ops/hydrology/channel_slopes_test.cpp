#include "seamount/ops/hydrology/channel_slopes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/water/flow.h"

namespace seamount::hydrology {
namespace {

/// Heights that rise along a tree of flow by `steepness` area^-concavity, found again until flow and heights agree.
HeightField steady_range(int width, int height, double cell_m, uint64_t seed, double concavity, double steepness) {
  HeightField terrain = geom::fbm_grid(GridFrame::centred(width, height, cell_m), Seed{seed},
                                       {.wavelength_m = 30 * cell_m, .octaves = 6}, {});
  for (int y = 0; y < height; ++y)  // a ridge along the middle, so that rivers lead out
    for (int x = 0; x < width; ++x)
      terrain(x, y) = 300.0F * terrain(x, y) + 20.0F * static_cast<float>(std::min(y, height - 1 - y));
  const std::array<int64_t, 8> steps = geom::flow_steps(width);
  for (int round = 0; round < 12; ++round) {
    const HeightField filled = geom::fill_depressions(terrain, geom::kNoSea, {});
    const geom::FlowDirections ways = geom::flow_directions(filled, geom::kNoSea, {});
    const Grid<uint32_t> cells = geom::flow_accumulation(ways, {});
    std::vector<int64_t> order(terrain.size());
    for (size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int64_t>(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](int64_t a, int64_t b) { return cells.data()[a] > cells.data()[b]; });  // receivers first
    for (const int64_t i : order) {
      if (ways.data()[i] >= 8) {
        terrain.data()[i] = 10.0F;
        continue;
      }
      const double area = static_cast<double>(cells.data()[i]) * cell_m * cell_m,
                   way = static_cast<double>(geom::kFlowLength[ways.data()[i]]) * cell_m;
      terrain.data()[i] = static_cast<float>(static_cast<double>(terrain.data()[i + steps[ways.data()[i]]]) +
                                             steepness * std::pow(area, -concavity) * way);
    }
  }
  return terrain;
}

ChannelSlopes read(const HeightField& terrain, float sea_m = geom::kNoSea) {
  const HeightField filled = geom::fill_depressions(terrain, sea_m, {});
  const geom::FlowDirections ways = geom::flow_directions(filled, sea_m, {});
  return channel_slopes(terrain, filled, ways, geom::flow_accumulation(ways, {}), sea_m, {});
}

TEST(ChannelSlopes, FindTheConcavityThatWasMade) {
  for (const uint64_t seed : {1, 2, 3}) {
    for (const double concavity : {0.3, 0.45, 0.5, 0.6}) {
      const HeightField range = steady_range(260, 220, 90, seed, concavity, 0.05 * std::pow(1e6, concavity));
      const ChannelSlopes found = read(range);
      EXPECT_EQ(found.from_m2, 1e6);
      EXPECT_NEAR(found.concavity, concavity, 0.02) << seed;
      ASSERT_GT(found.curve.size(), 6U);
      for (const SlopeOfArea& point : found.curve) {
        if (point.area_m2 < 1e6 || point.area_m2 > 2e7) continue;
        EXPECT_NEAR(point.slope / (0.05 * std::pow(point.area_m2 / 1e6, -concavity)), 1.0, 0.15) << point.area_m2;
      }
    }
  }
}

TEST(ChannelSlopes, BanksAndRoundedHeightsDoNotDisturb) {
  for (const uint64_t seed : {1, 2, 3}) {
    HeightField range = steady_range(260, 220, 90, seed, 0.45, 0.05 * std::pow(1e6, 0.45));
    for (float& z : range.cells()) z = std::round(z);
    EXPECT_NEAR(read(range).concavity, 0.45, 0.03) << seed;
  }
}

TEST(ChannelSlopes, OfLittleGroundBeginLower) {
  const HeightField range = steady_range(200, 180, 10, 5, 0.45, 0.1 * std::pow(1e5, 0.45));
  const ChannelSlopes found = read(range);
  EXPECT_LT(found.from_m2, 1e6);
  EXPECT_GE(found.from_m2, 1600.0);
  EXPECT_NEAR(found.concavity, 0.45, 0.05);
}

TEST(ChannelSlopes, LevelAndOddGroundHasNone) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {9, 1}, {3, 2}, {40, 30}}) {
    const ChannelSlopes found = read(HeightField(GridFrame::centred(width, height, 100), 7.0F));
    EXPECT_TRUE(std::isnan(found.concavity));
    EXPECT_TRUE(found.curve.empty());
  }
}

}  // namespace
}  // namespace seamount::hydrology
