#include "seamount/geom/solve/drain.h"

#include <gtest/gtest.h>

#include <cmath>

namespace seamount::geom {
namespace {

/// A bowl with a rim of 100 m, on a plain that falls to the border.
HeightField bowl(float floor_m) {
  HeightField ground(GridFrame::centred(61, 61, 10));
  for (int y = 0; y < 61; ++y) {
    for (int x = 0; x < 61; ++x) {
      const double r = std::hypot(x - 30, y - 30);
      ground(x, y) = r < 15 ? floor_m + static_cast<float>(r < 12 ? 0.0 : 30.0 * (r - 12))
                            : static_cast<float>(std::max(100.0 - 8.0 * (r - 15), -0.5 * r));
    }
  }
  return ground;
}

TEST(Drain, ABasinWithANearlyLevelFloorKeepsItsRim) {
  HeightField ground = bowl(20.0F);
  const float least = std::nextafter(20.0F, 0.0F);
  ground(30, 30) = std::nextafter(least, 0.0F);  // the sink that may stay
  ground(25, 33) = least;                        // one a hair higher, too near to it in height to fall there
  ground(36, 27) = ground(30, 30);               // and one as low
  const HeightField before = ground;
  const int64_t allowed = 30 * 61 + 30;
  drain(ground, {&allowed, 1}, {});
  EXPECT_EQ(find_sinks(ground, {}), std::vector<int64_t>{allowed});
  for (size_t i = 0; i < ground.size(); ++i) EXPECT_NEAR(ground.cells()[i], before.cells()[i], 1e-3) << i;
}

TEST(Drain, ABasinThatMayNotStayIsCutOpen) {
  HeightField ground = bowl(20.0F);
  ground(30, 30) = 10.0F;
  drain(ground, {}, {});
  EXPECT_TRUE(find_sinks(ground, {}).empty());
  int cut = 0;
  const HeightField before = bowl(20.0F);
  for (size_t i = 0; i < ground.size(); ++i) cut += ground.cells()[i] < before.cells()[i] - 1.0F ? 1 : 0;
  EXPECT_GT(cut, 5);
  EXPECT_LT(cut, 100) << "one channel, and the floor";
}

TEST(DrainShallow, OpensHollowsUpToADepthAndLeavesDeeperOnes) {
  HeightField heights(GridFrame::centred(41, 21, 10));
  for (int y = 0; y < 21; ++y)
    for (int x = 0; x < 41; ++x) heights(x, y) = static_cast<float>(100 + x);
  heights(10, 10) -= 4;   // 3 m below its lowest neighbour
  heights(30, 10) -= 20;  // 19 m
  heights(20, 5) -= 4;
  const HeightField before = heights;
  const int64_t meant = 5 * 41 + 20;
  std::vector<int64_t> sinks = find_sinks(heights, {});
  std::erase(sinks, meant);
  drain_shallow(heights, sinks, 10, {});
  EXPECT_EQ(find_sinks(heights, {}), (std::vector<int64_t>{meant, 10 * 41 + 30}));
  for (size_t i = 0; i < heights.size(); ++i) EXPECT_LE(heights.data()[i], before.data()[i]);
}

}  // namespace
}  // namespace seamount::geom
