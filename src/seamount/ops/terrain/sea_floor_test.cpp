#include "seamount/ops/terrain/sea_floor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace seamount::terrain {
namespace {

/// A cone of land in a level sea, its western half `steep` times as steep as its eastern one.
HeightField land_only(int side, double cell_m, double steep) {
  HeightField terrain(GridFrame::centred(side, side, cell_m));
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double px = terrain.frame().x(x), py = terrain.frame().y(y);
      const double z = 0.1 * (0.25 * side * cell_m - std::hypot(px, py)) * (px < 0 ? steep : 1.0);
      terrain(x, y) = z > 0 ? static_cast<float>(z) : 0.0F;
    }
  }
  return terrain;
}

TEST(SeaFloor, FallsFromTheCoastAndLeavesTheLand) {
  for (const double cell_m : {10.0, 30.0, 90.0}) {
    const HeightField terrain = land_only(200, cell_m, 1.0);
    const HeightField out = sea_floor(terrain, {}, {});
    float last = 0;
    for (int x = 100; x < 200; ++x) {
      if (terrain(x, 100) > 0) continue;
      ASSERT_LT(out(x, 100), last) << "deeper and deeper to the east, " << cell_m;
      last = out(x, 100);
    }
    for (size_t i = 0; i < terrain.size(); ++i) {
      if (terrain.cells()[i] > 0) {
        ASSERT_EQ(out.cells()[i], terrain.cells()[i]);
      } else {
        ASSERT_LT(out.cells()[i], 0);
        ASSERT_GT(out.cells()[i], -200.01F);
      }
    }
  }
}

TEST(SeaFloor, IsAsSteepAsTheLandBehindIt) {
  const HeightField out = sea_floor(land_only(200, 30, 4.0), {.depth_m = 2000}, {});
  const float west = out(40, 100), east = out(159, 100);  // 9 cells off either coast
  EXPECT_NEAR(west / east, 4.0, 0.8);
  EXPECT_NEAR(east, -0.5 * 0.1 * 9.5 * 30, 5);
}

TEST(SeaFloor, LeavesATerrainWithAFloorAlone) {
  HeightField terrain = land_only(64, 30, 1.0);
  for (float& z : terrain.cells())
    if (z == 0) z = -3.0F;
  std::string said;
  RunContext run;
  run.note = [&](const std::string& line) { said = line; };
  EXPECT_EQ(sea_floor(terrain, {}, run), terrain);
  EXPECT_NE(said.find("nothing to give a floor"), std::string::npos);
}

}  // namespace
}  // namespace seamount::terrain
