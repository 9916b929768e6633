#include "seamount/geom/water/inland.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/geom/water/flow.h"

namespace seamount::geom {
namespace {

/// Waters by walking from cell to cell.
HeightField raised_plainly(HeightField z, float sea, int64_t least) {
  std::vector<bool> seen(z.size());
  for (int32_t first = 0; first < static_cast<int32_t>(z.size()); ++first) {
    if (seen[static_cast<size_t>(first)] || z.data()[first] > sea) continue;
    std::vector<int32_t> water(1, first);
    seen[static_cast<size_t>(first)] = true;
    bool edge = false;
    for (size_t next = 0; next < water.size(); ++next) {
      const int x = water[next] % z.width(), y = water[next] / z.width();
      edge = edge || x == 0 || y == 0 || x == z.width() - 1 || y == z.height() - 1;
      for (size_t d = 0; d < 8; ++d) {
        const int nx = x + kFlowDx[d], ny = y + kFlowDy[d];
        if (!z.contains(nx, ny) || z(nx, ny) > sea) continue;
        const int32_t other = ny * z.width() + nx;
        if (seen[static_cast<size_t>(other)]) continue;
        seen[static_cast<size_t>(other)] = true;
        water.push_back(other);
      }
    }
    if (edge || static_cast<int64_t>(water.size()) >= least) continue;
    for (const int32_t cell : water) z.data()[cell] = std::nextafter(sea, INFINITY);
  }
  return z;
}

TEST(Inland, RaisesEnclosedWaterThatIsSmall) {
  for (uint64_t seed = 0; seed < 300; ++seed) {
    Rng rng(Seed{seed});
    const int width = rng.integer(1, 24), height = rng.integer(1, 24);
    HeightField z(GridFrame::centred(width, height, 10));
    const double wet = rng.uniform(0.1, 0.7);
    for (float& value : z.cells()) value = static_cast<float>(rng.chance(wet) ? -rng.uniform() : rng.uniform());
    const int least = rng.integer(1, 12);
    EXPECT_EQ(raise_inland(z, 0.0F, 100.0 * least, {}), raised_plainly(z, 0.0F, least)) << seed;
  }
}

/// A bowl of that depth and share of the width, behind a rim of that height, on a plain at 20 m that ends in the sea.
HeightField bowl(float depth_m, double share, float rim_m) {
  HeightField z(GridFrame::centred(101, 81, 100), 20.0F);
  for (int y = 0; y < 81; ++y) {
    for (int x = 0; x < 101; ++x) {
      const double r = std::hypot(x - 50, y - 40);
      if (r < 50 * share) z(x, y) = -depth_m;
      if (x < 3) z(x, y) = -30.0F;
      if (y == 40 && r >= 50 * share && x < 50 && x >= 3) z(x, y) = rim_m;  // the lowest way out
    }
  }
  return z;
}

TEST(Inland, LargeEnclosedWaterIsSeaBehindALowRimOrIfItIsDeep) {
  const auto hollow = [](const HeightField& z, std::optional<double> least = {}) {
    const Grid<uint8_t> found = find_hollows(z, 0.0F, least, {});
    return !found.empty() && found(50, 40) == 1 && found(0, 0) == 0;
  };
  EXPECT_TRUE(hollow(bowl(400, 0.5, 15)));       // the Dead Sea
  EXPECT_TRUE(hollow(bowl(400, 0.5, 15), 1e9));  // or said so
  EXPECT_FALSE(hollow(bowl(400, 0.5, 15), 1e6));
  EXPECT_FALSE(hollow(bowl(30, 0.5, 3)));      // an atoll's lagoon
  EXPECT_TRUE(hollow(bowl(3, 0.05, 3)));       // a polder
  EXPECT_TRUE(hollow(bowl(6, 0.5, 3)));        // a large one
  EXPECT_TRUE(hollow(bowl(6, 0.5, 3)));        // a large one
  EXPECT_FALSE(hollow(bowl(2000, 0.5, 15)));   // the Black Sea
  EXPECT_FALSE(hollow(bowl(2000, 0.05, 15)));  // on a map of the world
  EXPECT_TRUE(hollow(bowl(2000, 0.5, 15), 1e9));
  std::vector<std::string> said;
  RunContext run;
  run.note = [&](const std::string& line) { said.push_back(line); };
  find_hollows(bowl(400, 0.5, 15), 0.0F, {}, run);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("count as land: behind a high rim"), std::string::npos) << said[0];
}

TEST(Inland, LoweredSeaLeavesHollowsAsTheyAre) {
  const HeightField z = bowl(400, 0.5, 15);
  float sea = 0.0F;
  const HeightField lowered = lower_sea(z, sea, {}, {});
  EXPECT_EQ(sea, -401.0F);
  for (int y = 0; y < 81; ++y)
    for (int x = 0; x < 101; ++x) ASSERT_EQ(lowered(x, y), x < 3 ? sea : z(x, y));
  float none = kNoSea;
  EXPECT_EQ(lower_sea(z, none, {}, {}), z);
  EXPECT_EQ(none, -401.0F);
}

TEST(Inland, WithoutASeaNothingChanges) {
  const HeightField z(GridFrame::centred(9, 9, 10), -4.0F);
  EXPECT_EQ(raise_inland(z, kNoSea, {}, {}), z);
  EXPECT_EQ(raise_inland(z, 0.0F, {}, {}), z);  // all of it reaches the edge
}

}  // namespace
}  // namespace seamount::geom
